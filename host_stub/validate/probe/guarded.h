#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

namespace burin::validate {

/// Where an array lies in its pages: it begins where the guard before it ends, ends where the guard behind it
/// begins, or has neither near.
enum class Guard { before, behind, none };

/// An array of floats with a page that nobody may touch before it or behind it.
class Guarded {
 public:
  /// Copies the numbers.
  Guarded(std::span<const float> numbers, Guard guard);
  Guarded(const Guarded&) = delete;
  Guarded& operator=(const Guarded&) = delete;
  ~Guarded();

  float* data() const { return data_; }

 private:
  void* pages_;
  std::size_t bytes_;
  float* data_;
};

}  // namespace burin::validate
