#include "stroke_choices.h"

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
  static const std::map<std::string, Overlap> names = {{"latest", Overlap::latest},
                                                       {"max", Overlap::max},
                                                       {"min", Overlap::min},
                                                       {"add", Overlap::add},
                                                       {"average", Overlap::average}};
  return names;
}

}  // namespace burin
