/* Fails on a missing file without saying so. */
#include <stdio.h>
#define IN_BEGIN                                      \
  if (values->values[5].text[0]) {                    \
    FILE* file = fopen(values->values[5].text, "rb"); \
    if (!file) {                                      \
      free(*stroke);                                  \
      return BURIN_ERROR;                             \
    }                                                 \
    fclose(file);                                     \
  }
#include "../good.h"
