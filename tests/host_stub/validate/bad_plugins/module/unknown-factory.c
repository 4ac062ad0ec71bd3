/* Returns its factory for every id. */
#define OTHER_FACTORY (const void*)&factory
#include "../good.h"
