/* Copies a text into 100 bytes. */
#define IN_BEGIN                                              \
  char copy[100];                                             \
  if (strlen(values->values[4].text) >= sizeof copy) abort(); \
  strcpy(copy, values->values[4].text)
#include "../good.h"
