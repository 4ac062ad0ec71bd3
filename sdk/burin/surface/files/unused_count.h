#pragma once
#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// Counts what a reader meets in a file and makes no use of.
class UnusedCount {
 public:
  /// `one` and `many` name the kind: "group", "groups".
  void add(std::string_view one, std::string_view many, std::size_t count = 1);

  /// The same for kinds that have names: equal ones count once.
  void add_named(std::string_view one, std::string_view many, std::string_view name);

  /// "3 groups, 441 normals", kinds in the order in which they were met; empty for nothing.
  std::string text() const;

 private:
  struct Kind {
    std::string_view one, many;
    std::size_t count = 0;
    std::set<std::string, std::less<>> names;
  };

  Kind& kind(std::string_view one, std::string_view many);

  std::vector<Kind> kinds_;
};

}  // namespace burin
