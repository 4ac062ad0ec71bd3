// Counts ignored items for the warning that a reader gives at the end.
#include <burin/surface/files/unused_count.h>
#include <fmt/format.h>

#include <algorithm>

namespace burin {

UnusedCount::Kind& UnusedCount::kind(std::string_view one, std::string_view many) {
  const auto found = std::ranges::find(kinds_, one, &Kind::one);
  if (found != kinds_.end()) return *found;
  return kinds_.emplace_back(Kind{one, many, 0, {}});
}

void UnusedCount::add(std::string_view one, std::string_view many, std::size_t count) {
  if (count > 0) kind(one, many).count += count;
}

void UnusedCount::add_named(std::string_view one, std::string_view many, std::string_view name) {
  Kind& named = kind(one, many);
  if (!named.names.contains(name)) named.names.emplace(name);
  named.count = named.names.size();
}

std::string UnusedCount::text() const {
  std::string text;
  for (const Kind& kind : kinds_) {
    if (!text.empty()) text += ", ";
    text += fmt::format("{} {}", kind.count, kind.count == 1 ? kind.one : kind.many);
  }
  return text;
}

}  // namespace burin
