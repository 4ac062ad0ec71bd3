// Has a version in words.
#define VERSION "beta"
#include "../good_cpp.h"
