#pragma once
#include <burin/ink/parse/xml.h>

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace burin {

/// When the times of InkML traces begin, by the timestamps of their contexts.
class InkmlClocks {
 public:
  explicit InkmlClocks(const XmlFile& file);

  /// Seconds from the earliest timestamp of a context to that of the one that a reference "#id" names; 0 if
  /// that has none.
  double of(std::string_view context) const;

 private:
  using Clock = std::optional<double>;  ///< milliseconds since 1970
  void collect(const pugi::xml_node& node);
  void take_context(const pugi::xml_node& context);
  Clock time_of(const pugi::xml_node& stamp) const;

  std::map<std::string, Clock, std::less<>> stamps_, contexts_;  ///< by "#id"
  Clock earliest_;                                               ///< of the contexts
};

}  // namespace burin
