#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace burin {

/// What came of a task in a process of its own.
struct ChildResult {
  enum class End {
    whole,    ///< the task returned
    crashed,  ///< a signal or the task itself ended the process
    late,     ///< it was ended at the time limit
  };
  End end = End::whole;
  std::string text;    ///< what the task returned, at most 4000 bytes; else how the process ended, one line
  double seconds = 0;  ///< of wall-clock time
};

/// Calls task(0) to task(count - 1), each in a copy of this process that ends with this one, `jobs` at a
/// time. What they print is discarded. `limit`: seconds that each may take. No other thread may work in
/// this process, since copies would lack it; those that libraries start and that wait, as OpenVDB's do for
/// its log, are no harm.
std::vector<ChildResult> run_in_children(std::size_t count, int jobs, double limit,
                                         const std::function<std::string(std::size_t)>& task);

}  // namespace burin
