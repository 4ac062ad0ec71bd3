// Lists all checks, topic by topic, and finds them by their names.
#include "validate/probe/check.h"

#include <vector>

namespace burin::validate {

std::span<const Check> all_checks() {
  static const std::vector<Check> checks = [] {
    std::vector<Check> all;
    for (const auto topic : {module_checks, descriptor_checks, struct_checks, value_checks, life_checks,
                             host_checks, evaluate_checks, memory_checks, process_checks, shape_checks,
                             repeat_checks, ability_checks, speed_checks})
      all.insert(all.end(), topic().begin(), topic().end());
    return all;
  }();
  return checks;
}

const Check* find_check(std::string_view name) {
  for (const Check& check : all_checks())
    if (check.name == name) return &check;
  return nullptr;
}

}  // namespace burin::validate
