// Divides the samples whose discs hold a vertex into visits. A run of such samples is cut at maxima of the
// straight distance that exceed the minima on both sides by a tenth of the disc, which is more than the
// tremble of a hand. Costs O(length of the run).
#include <burin/chart/path/visit.h>

namespace burin {
namespace {

/// The share of the disc's radius by which the stroke must move away and come back to start another visit.
constexpr float least_turn = 0.1F;

}  // namespace

Visits::Found Visits::find(Index sample, Index floor) const {
  const Index count = samples_->size();
  Index begin = run_begin(sample, floor), most = samples_->closed() ? count : no_index, decided_by = no_index;
  for (;;) {
    const Visit visit = from(begin, most);
    if (samples_->steps(begin, sample) < visit.length) return {visit, decided_by};
    decided_by = visit.decided_by;
    most -= visit.length;
    begin = (begin + visit.length) % count;
  }
}

/// The first sample of the run that holds `sample`. When all samples of a closed stroke are in reach, the run
/// starts after the farthest one.
Index Visits::run_begin(Index sample, Index floor) const {
  const bool closed = samples_->closed();
  Index begin = sample;
  while (closed || begin > floor) {
    const Index before = (begin == 0 ? samples_->size() : begin) - 1;
    if (!any(before)) break;
    begin = before;
    if (begin == sample) return (farthest() + 1) % samples_->size();
  }
  return begin;
}

Index Visits::farthest() const {
  Index farthest = 0;
  for (Index sample = 1; sample < samples_->size(); ++sample)
    if (distance(sample) > distance(farthest)) farthest = sample;
  return farthest;
}

Visit Visits::from(Index begin, Index most) const {
  const Index count = samples_->size();
  float low = distance(begin), high = low, last = low;
  Index length = 1, up_to_high = 1, at = begin, decided_by = no_index;
  for (;; ++length) {
    const float turn = least_turn * samples_->disc(at);
    const bool went_away = high - low >= turn, comes_back = went_away && last < high;
    if (length == most) return {begin, length, true, decided_by};
    if (++at == count) {
      if (!samples_->closed()) return {begin, length, false, comes_back ? count : decided_by};
      at = 0;
    }
    if (!any(at)) return {begin, length, true, comes_back ? at : decided_by};
    last = distance(at);
    if (went_away && high - last >= turn) return {begin, up_to_high, true, at};
    if (last < low) low = high = last;
    if (last < high) continue;
    if (comes_back) decided_by = at;
    high = last;
    up_to_high = length + 1;
  }
}

}  // namespace burin
