#include "options/stroke_choices.h"

namespace burin {

const std::map<std::string, Closure>& closure_names() {
  static const std::map<std::string, Closure> names = {
      {"yes", Closure::closed}, {"no", Closure::open}, {"auto", Closure::automatic}};
  return names;
}

const std::map<std::string, Join>& join_names() {
  static const std::map<std::string, Join> names = {
      {"round", Join::round}, {"smooth", Join::smooth}, {"miter", Join::miter}, {"overlap", Join::overlap}};
  return names;
}

const std::map<std::string, Overlap>& overlap_names() {
  static const auto names = [] {
    std::map<std::string, Overlap> all;
    for (const auto& [name, overlap] : named_overlaps) all.emplace(name, overlap);
    return all;
  }();
  return names;
}

}  // namespace burin
