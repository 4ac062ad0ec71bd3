// Keeps a session's surface, its paint, its picker and its chart builders in step. A stroke's end costs
// O(vertices that it changed); only a surface that is replaced is made anew as a whole.
#include <burin/base/error.h>
#include <burin/host/session/sculpted_surface.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

namespace burin {

SculptedSurface::SculptedSurface(Surface surface)
    : surface_(std::move(surface)),
      picker_(surface_),
      builders_(std::make_unique<ChartBuilders>(surface_, picker_)),
      shown_(surface_),
      paint_(surface_.vertex_count()) {}

void SculptedSurface::set_paint(Paint paint) {
  const Index count = surface_.vertex_count();
  const auto one_each = [&](const auto& values) { return values.empty() || values.size() == count; };
  const auto within = [](const auto& value) { return value >= 0 && value <= 1; };
  const bool sound = one_each(paint.colour) && one_each(paint.mask) &&
                     std::ranges::all_of(paint.mask, within) &&
                     std::ranges::all_of(paint.colour, [&](const Vec4f& colour) {
                       return std::all_of(colour.begin(), colour.end(), within);
                     });
  if (!sound) throw ContractError("colours and masks must be from 0 to 1, one a vertex");
  paint_.assign(std::move(paint));
}

void SculptedSurface::move(std::span<const Index> vertices, std::span<const Vec3f> positions) {
  const bool sound = vertices.size() == positions.size() &&
                     std::ranges::all_of(vertices, [&](Index v) { return v < surface_.vertex_count(); }) &&
                     std::ranges::all_of(positions, [](const Vec3f& p) { return p.allFinite(); });
  if (!sound) throw ContractError("vertices must be there, and have one finite position each");
  note_changed(shown_.move(surface_, vertices, positions), {});
  commit(shown_.take_displaced(surface_));
}

void SculptedSurface::show(const VertexMoves& moves) {
  const std::span<const Index> moved = shown_.move(surface_, moves.vertices, moves.positions);
  std::vector<Index> painted;
  if (!moves.tints.empty()) paint_.set(moves.vertices, moves.tints, painted);
  std::ranges::sort(painted);
  note_changed(moved, painted);
}

void SculptedSurface::drop() {
  const std::vector<Index> displaced = shown_.take_displaced(surface_);
  std::vector<Vec3f> bases;
  bases.reserve(displaced.size());
  for (const Index vertex : displaced) bases.push_back(surface_.positions[vertex]);
  note_changed(shown_.move(surface_, displaced, bases), paint_.drop());
  shown_.take_displaced(surface_);
}

void SculptedSurface::keep(MadePart made) {
  const std::vector<Index> displaced = shown_.take_displaced(surface_);
  journal_.record(displaced, surface_.positions, paint_.commit(), made);
  end_redoing();
  commit(displaced);
}

void SculptedSurface::replace(PaintedSurface made) {
  Paint before = paint_.base();
  Surface replaced = std::move(surface_);
  builders_->free_strokes();
  replaced_builders_.push_back(std::move(builders_));
  exchange(std::move(made));
  builders_ = std::make_unique<ChartBuilders>(surface_, picker_);
  journal_.record(std::move(replaced), std::move(before));
  end_redoing();
}

void SculptedSurface::end_redoing() {
  undone_.clear();
  undone_builders_.clear();
  drop_oldest();
}

void SculptedSurface::limit_undo(std::size_t bytes) {
  most_undo_bytes_ = bytes;
  drop_oldest();
}

void SculptedSurface::drop_oldest() {
  while (journal_.size() > 0 && undo_bytes() > most_undo_bytes_)
    if (journal_.drop_oldest().surface) replaced_builders_.erase(replaced_builders_.begin());
}

void SculptedSurface::show(const UndoStep& step) {
  note_changed(shown_.move(surface_, step.vertices, step.positions), step.paint.vertices);
}

void SculptedSurface::restore(UndoStep step, Turn turn) {
  UndoStep replaced =
      step.surface ? restore_surface(std::move(step), turn) : restore_vertices(std::move(step));
  steps(turn == Turn::undo ? Turn::redo : Turn::undo).record(std::move(replaced));
}

UndoStep SculptedSurface::restore_surface(UndoStep step, Turn turn) {
  UndoStep replaced;
  replaced.surface_paint = paint_.base();
  replaced.surface = std::move(surface_);
  builders_->free_strokes();
  builders_of(turn == Turn::undo ? Turn::redo : Turn::undo).push_back(std::move(builders_));
  exchange({std::move(*step.surface), std::move(step.surface_paint)});
  builders_ = std::move(builders_of(turn).back());
  builders_of(turn).pop_back();
  return replaced;
}

UndoStep SculptedSurface::restore_vertices(UndoStep step) {
  for (std::size_t i = 0; i < step.vertices.size(); ++i)
    step.positions[i] = surface_.positions[step.vertices[i]];
  commit(step.vertices);
  step.paint = paint_.restore(step.paint);
  return step;
}

/// Sets `changed_` to the union of two ascending lists.
void SculptedSurface::note_changed(std::span<const Index> moved, std::span<const Index> painted) {
  changed_.clear();
  std::ranges::set_union(moved, painted, std::back_inserter(changed_));
}

/// Copies the shown positions to the surface and updates everything that depends on it.
void SculptedSurface::commit(std::span<const Index> displaced) {
  float farthest = 0;
  for (const Index vertex : displaced)
    farthest = std::max(farthest, (shown_.positions()[vertex] - surface_.positions[vertex]).squaredNorm());
  shown_.commit(surface_, displaced);
  picker_.update(displaced);
  builders_->moved(displaced, std::sqrt(static_cast<double>(farthest)));
}

/// Makes all that depends on the surface anew, but for the chart builders.
void SculptedSurface::exchange(PaintedSurface made) {
  surface_ = std::move(made.surface);
  picker_ = Picker(surface_);
  shown_ = ShownSurface(surface_);
  paint_ = ShownPaint(surface_.vertex_count());
  paint_.assign(std::move(made.paint));
  ++generation_;
  changed_.resize(surface_.vertex_count());
  std::iota(changed_.begin(), changed_.end(), Index{0});
}

}  // namespace burin
