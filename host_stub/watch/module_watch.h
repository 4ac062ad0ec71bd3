#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>

namespace burin {

/// Waits for a module to be built anew.
class ModuleWatch {
 public:
  /// Changes from now on count.
  explicit ModuleWatch(std::filesystem::path module);

  /// Waits until the file has changed and is whole: while somebody writes it, or a library's end is missing,
  /// it goes on waiting, but not for longer than 5 seconds after the last change.
  void wait();

 private:
  struct State {
    std::filesystem::file_time_type time;
    std::uintmax_t size;
    bool operator==(const State&) const = default;
  };
  std::optional<State> look() const;

  std::filesystem::path module_;
  std::optional<State> seen_;
};

}  // namespace burin
