// Chooses a locale for the numbers in its files.
#include <locale>
#define IN_BEGIN std::locale::global(std::locale("C.UTF-8"))
#include "../good_cpp.h"
