/* Asks for no pass. */
#define PASSES 0
#include "../good.h"
