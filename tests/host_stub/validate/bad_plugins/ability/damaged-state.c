/* Trusts what it loads. */
#define IN_LOAD \
  if (size > 1000) abort()
#include "../good.h"
