#pragma once
#include <span>
#include <vector>

namespace burin {

/// What has to be laid along a stroke, object units.
struct CopyLengths {
  double start = 0, middle = 0, end = 0;  ///< of the parts; 0 for none, the middle above 0
  double stroke = 0;                      ///< of the stroke
  double spacing = 0;                     ///< from copy to copy of the middle part; 0: end to end
  bool closed = false;                    ///< the stroke is, and has neither start nor end
};

/// Where a copy of a part lies along the stroke, object units: its begin and its end.
struct CopyInterval {
  enum class Part { start, middle, end };
  Part part = Part::middle;
  double begin = 0, end = 0;
};

/// Lays parts along a stroke, in the order of where they begin. Copies that lie end to end share one number.
///
/// The parts at start and end keep their lengths where both find room, else in proportion. Between them is a
/// whole number of copies of the middle part, stretched or pressed to fill it: as near to their own length as
/// can be. With a spacing, copies of their own length stand so far apart, the first where the start part
/// ends, and as many as find room; where not even one does, one is pressed. Around a closed stroke the
/// spacing is stretched to a whole number of copies, and the copies with it.
///
/// Throws Error where there would be more than `most` copies.
std::vector<CopyInterval> lay_copies(const CopyLengths& lengths, double most);

}  // namespace burin
