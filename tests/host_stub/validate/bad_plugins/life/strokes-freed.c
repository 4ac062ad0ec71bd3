/* Forgets the memory of strokes. */
static void forget(void* stroke) { (void)stroke; }
#define FREE forget
#include "../good.h"
