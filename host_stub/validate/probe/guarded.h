#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

namespace burin::validate {

/// An array of floats with a page that nobody may touch before it or behind it.
class Guarded {
 public:
  /// Copies the numbers so that they end where the page behind begins, or begin where the one before ends.
  Guarded(std::span<const float> numbers, bool at_end);
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
