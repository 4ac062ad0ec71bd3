// Makes a table once, with the parameters of the stroke that comes first.
#include <vector>
static std::vector<float> table;
#define IN_BEGIN \
  if (table.empty()) table.assign(16, 1 + 0.1f * static_cast<float>(start.params[count].value()))
#define AT_NODE up[i] *= table[i % table.size()]
#include "../good_cpp.h"
