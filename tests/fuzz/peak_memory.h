#pragma once
#include <sys/resource.h>

namespace burin::fuzz {

/// The most physical memory that this process has held so far, bytes.
inline double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024;
}

}  // namespace burin::fuzz
