#include <burin/abi/stroke.h>
#include <burin/deform/stroke_changes.h>

#include <cstddef>

namespace burin {
namespace {

/// The nodes [begin, end) of a vertex.
struct Sheets {
  Index begin, end;
  Index count() const { return end - begin; }
};

class ChangeFinder {
 public:
  ChangeFinder(const StrokeNodes& before, const StrokeNodes& now, double end_zone, std::uint64_t inputs)
      : before_(before), now_(now), end_zone_(end_zone), inputs_(inputs) {}

  StrokeChanges find();

 private:
  Sheets sheets_before(Index vertex);
  void compare(const Sheets& old, const Sheets& now);
  bool same_inputs(const Sheets& old, Index i, const Sheets& now, Index j) const;

  const StrokeNodes &before_, &now_;
  double end_zone_;
  std::uint64_t inputs_;
  Index next_before_ = 0;
  StrokeChanges changes_;
};

StrokeChanges ChangeFinder::find() {
  const auto size = static_cast<Index>(now_.chart.size());
  changes_.before.resize(size, no_index);
  for (Index first = 0; first < size;) {
    const Sheets now{first, sheets_end(now_.chart, first)};
    compare(sheets_before(now_.chart.vertex[first]), now);
    first = now.end;
  }
  sheets_before(no_index);
  return std::move(changes_);
}

/// The nodes that the vertex had. Vertices are asked for in ascending order; those in between have left.
Sheets ChangeFinder::sheets_before(Index vertex) {
  const Chart& chart = before_.chart;
  const auto size = static_cast<Index>(chart.size());
  while (next_before_ < size && chart.vertex[next_before_] < vertex) {
    changes_.left.push_back(chart.vertex[next_before_]);
    next_before_ = sheets_end(chart, next_before_);
  }
  const Index begin = next_before_;
  if (begin < size && chart.vertex[begin] == vertex) next_before_ = sheets_end(chart, begin);
  return {begin, next_before_};
}

void ChangeFinder::compare(const Sheets& old, const Sheets& now) {
  const std::size_t stale_before = changes_.stale.size();
  Index i = old.begin;
  for (Index j = now.begin; j < now.end; ++j) {
    const double t = now_.chart.t[j];
    while (i < old.end && before_.chart.t[i] < t) ++i;
    if (i < old.end && t < end_zone_ && same_inputs(old, i, now, j))
      changes_.before[j] = i++;
    else
      changes_.stale.push_back(j);
  }
  if (changes_.stale.size() > stale_before || old.count() != now.count())
    changes_.altered.push_back(now.begin);
}

bool ChangeFinder::same_inputs(const Sheets& old, Index i, const Sheets& now, Index j) const {
  const Chart &a = before_.chart, &b = now_.chart;
  if (a.t[i] != b.t[j] || a.d[i] != b.d[j] || a.e1[i] != b.e1[j] || a.stretch[i] != b.stretch[j])
    return false;
  if (inputs_ & BURIN_INPUT_SHEET && a.sheet[i] != b.sheet[j]) return false;
  if (inputs_ & BURIN_INPUT_VISIT_COUNT && old.count() != now.count()) return false;
  if (!now_.half_width.empty() && before_.half_width[i] != now_.half_width[j]) return false;
  return now_.pen.empty() || before_.pen[i] == now_.pen[j];
}

}  // namespace

StrokeChanges find_changes(const StrokeNodes& before, const StrokeNodes& now, double end_zone,
                           std::uint64_t inputs) {
  return ChangeFinder(before, now, end_zone, inputs).find();
}

}  // namespace burin
