/* Cannot be unloaded, as it is linked. */
#include "../good.h"
