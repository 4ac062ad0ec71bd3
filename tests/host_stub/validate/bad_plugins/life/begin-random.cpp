// Throws for an odd count that is not its default, which its range allows.
#define IN_BEGIN \
  if (start.params[count].value() == 5) throw Error("no five, please")
#include "../good_cpp.h"
