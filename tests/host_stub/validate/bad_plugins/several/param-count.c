/* Counts more parameters than it lists, so that what follows the list is taken for them. */
#define PARAM_COUNT 4000
#include "../good.h"
