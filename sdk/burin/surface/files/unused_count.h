#pragma once
#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// Counts the items of a file that a reader ignores, by kind.
class UnusedCount {
 public:
  /// Adds items of a kind; `one` and `many` are its names: "group", "groups". They must outlive the object.
  void add(std::string_view one, std::string_view many, std::size_t count = 1);

  /// Adds a named item of a kind; items with equal names count once.
  void add_named(std::string_view one, std::string_view many, std::string_view name);

  /// Lists the counts, "3 groups, 441 normals", in order of first appearance; empty if there are none.
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
