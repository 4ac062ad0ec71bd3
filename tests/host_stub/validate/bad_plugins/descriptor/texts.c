/* Has a name that is no UTF-8. */
#define NAME "\xFF\xFE"
#include "../good.h"
