// Names the wrap modes.
#include <burin/stamp/wrap.h>

#include <algorithm>
#include <array>

namespace burin {
namespace {

constexpr std::array<std::string_view, 5> wrap_names = {"unknown", "periodic", "mirror", "clamp", "black"};

}  // namespace

std::string_view wrap_name(Wrap wrap) { return wrap_names[static_cast<std::size_t>(wrap)]; }

Wrap parse_wrap(std::string_view name) {
  const auto found = std::ranges::find(wrap_names, name);
  return found == wrap_names.end() ? Wrap::unknown : static_cast<Wrap>(found - wrap_names.begin());
}

std::pair<Wrap, Wrap> parse_wraps(std::string_view names) {
  const std::size_t comma = names.find(',');
  const Wrap u = parse_wrap(names.substr(0, comma));
  return {u, comma == names.npos ? u : parse_wrap(names.substr(comma + 1))};
}

}  // namespace burin
