/* Has no fault. */
#include "good.h"
