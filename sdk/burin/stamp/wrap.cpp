#include <burin/stamp/wrap.h>

#include <algorithm>
#include <array>

namespace burin {
namespace {

constexpr std::array<std::string_view, 5> names = {"unknown", "periodic", "mirror", "clamp", "black"};

}  // namespace

std::string_view wrap_name(Wrap wrap) { return names[static_cast<std::size_t>(wrap)]; }

Wrap wrap_named(std::string_view name) {
  const auto found = std::ranges::find(names, name);
  return found == names.end() ? Wrap::unknown : static_cast<Wrap>(found - names.begin());
}

}  // namespace burin
