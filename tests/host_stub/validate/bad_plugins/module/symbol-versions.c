/* Needs a symbol of a newer system. */
int burin_test_newer(void);
#define IN_BEGIN *(int*)*stroke = burin_test_newer()
#include "../good.h"
