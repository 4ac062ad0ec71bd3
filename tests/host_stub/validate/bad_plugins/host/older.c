/* Reads dab_t of hosts that have none. */
#define AT_NODE AT(outputs->up, i) += (float)(context->dab_t != context->dab_t || context->dab_t < -1e100)
#include "../good.h"
