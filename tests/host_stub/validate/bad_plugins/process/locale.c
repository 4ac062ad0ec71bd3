/* Changes the locale. */
#include <locale.h>
#define IN_EVALUATE \
  if (batch->count == 1000) setlocale(LC_ALL, "C.UTF-8")
#include "../good.h"
