/* Exports a function besides its entry. */
__attribute__((visibility("default"))) int helper(void);
int helper(void) { return 1; }
#include "../good.h"
