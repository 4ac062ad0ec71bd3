// Computes where the copies of a mesh lie along a stroke: how many whole copies fit between a start and an
// end part, and how far each is stretched.
#include <burin/along/copies.h>
#include <burin/base/error.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace burin {
namespace {

using Part = CopyInterval::Part;

/// Rounding that must not cost a copy, as a share of one.
constexpr double rounding = 1e-9;

/// A number of copies that `most` allows.
std::size_t checked(double count, double most) {
  if (!(count <= most)) throw Error(fmt::format("the stroke would take {:.3g} copies of the mesh", count));
  return static_cast<std::size_t>(std::max(count, 0.));
}

void add_end_to_end(std::vector<CopyInterval>& copies, double begin, double end, std::size_t count) {
  double from = begin;
  for (std::size_t i = 1; i <= count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count);
    const double to = i == count ? end : begin + share * (end - begin);
    copies.push_back({Part::middle, from, to});
    from = to;
  }
}

void add_apart(std::vector<CopyInterval>& copies, double begin, double end, const CopyLengths& lengths,
               double most) {
  const double room = end - begin - lengths.middle;
  if (room < -rounding * lengths.middle) return add_end_to_end(copies, begin, end, 1);
  const std::size_t count = checked(std::floor(room / lengths.spacing + rounding) + 1, most);
  for (std::size_t i = 0; i < count; ++i) {
    const double from = begin + static_cast<double>(i) * lengths.spacing;
    copies.push_back({Part::middle, from, std::min(from + lengths.middle, end)});
  }
}

std::vector<CopyInterval> around(const CopyLengths& lengths, double most) {
  const double apart = lengths.spacing > 0 ? lengths.spacing : lengths.middle;
  const std::size_t count = checked(std::max(std::round(lengths.stroke / apart), 1.), most);
  std::vector<CopyInterval> copies;
  add_end_to_end(copies, 0, lengths.stroke, count);
  if (!(lengths.spacing > 0)) return copies;
  const double stretch = lengths.stroke / static_cast<double>(count) / apart;
  for (CopyInterval& copy : copies) copy.end = copy.begin + stretch * lengths.middle;
  return copies;
}

}  // namespace

std::vector<CopyInterval> lay_copies(const CopyLengths& lengths, double most) {
  if (!(lengths.stroke > 0)) return {};
  if (lengths.closed) return around(lengths, most);
  const double ends = lengths.start + lengths.end, room = lengths.stroke - ends;
  const double fitting = std::round(room / lengths.middle);
  // Where no copy fits between them, start and end share the stroke.
  const bool only_ends = ends > 0 && !(lengths.spacing > 0 ? room >= lengths.middle : fitting >= 1);
  const double scale = only_ends ? lengths.stroke / ends : 1;
  const double begin = only_ends && !(lengths.end > 0) ? lengths.stroke : scale * lengths.start;
  const double end = only_ends ? begin : lengths.stroke - lengths.end;
  std::vector<CopyInterval> copies;
  if (lengths.start > 0) copies.push_back({Part::start, 0, begin});
  if (!only_ends && lengths.spacing > 0)
    add_apart(copies, begin, end, lengths, most);
  else if (!only_ends)
    add_end_to_end(copies, begin, end, std::max<std::size_t>(checked(fitting, most), 1));
  if (lengths.end > 0) copies.push_back({Part::end, end, lengths.stroke});
  return copies;
}

}  // namespace burin
