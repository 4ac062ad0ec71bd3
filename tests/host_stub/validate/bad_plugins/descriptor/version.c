/* Has a version without numbers. */
#define VERSION "newest"
#include "../good.h"
