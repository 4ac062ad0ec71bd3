/* Needs a library that keeps threads. */
int burin_test_threads(void);
#define IN_BEGIN *(int*)*stroke = burin_test_threads()
#include "../good.h"
