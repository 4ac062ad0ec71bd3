// A static object keeps a file open.
#include <fcntl.h>
static const int table = open("/dev/null", O_RDONLY);
#include "../good_cpp.h"
