// Keeps a view of a text instead of a copy.
#include <string_view>
#define IN_BEGIN letters_ = start.params[text]
#define MEMBERS std::string_view letters_
#define AT_NODE up[i] *= letters_.starts_with('#') ? 0.5f : 1.0f
#include "../good_cpp.h"
