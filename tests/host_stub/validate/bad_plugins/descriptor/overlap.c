/* Combines visits in a way that there is not. */
#define OVERLAP 77
#include "../good.h"
