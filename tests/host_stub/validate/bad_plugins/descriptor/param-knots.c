/* Has a curve whose x does not rise. */
#define KNOTS 0, 0, 0, 1
#include "../good.h"
