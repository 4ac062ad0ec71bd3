/* Writes an error text of 30 bytes whatever the capacity. */
#define IN_CREATE                                          \
  if (error && strcmp(brush_id, ID) != 0) {                \
    strcpy(error->data, "there is no such brush in here"); \
    return NULL;                                           \
  }
#include "../good.h"
