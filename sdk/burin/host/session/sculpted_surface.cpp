// Keeps a session's surface, its paint, its picker and its chart builders in step. A stroke's end costs
// O(vertices that it changed); only a surface that is replaced is made anew as a whole.
#include <burin/base/error.h>
#include <burin/base/sort_unique.h>
#include <burin/host/session/released_step.h>
#include <burin/host/session/sculpted_surface.h>
#include <burin/surface/connect_surface.h>
#include <burin/surface/geometry/triangle_shape.h>
#include <burin/surface/source_numbers.h>

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
      given_(surface_),
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
  state_.reset();
}

void SculptedSurface::move(std::span<const Index> vertices, std::span<const Vec3f> positions) {
  const bool sound = vertices.size() == positions.size() &&
                     std::ranges::all_of(vertices, [&](Index v) { return v < surface_.vertex_count(); }) &&
                     std::ranges::all_of(positions, [](const Vec3f& p) { return p.allFinite(); });
  if (!sound) throw ContractError("vertices must be there, and have one finite position each");
  note_changed(shown_.move(surface_, vertices, positions), {});
  commit(shown_.take_displaced(surface_));
}

SculptedSurface::Triangles SculptedSurface::shown_triangles(const std::vector<bool>& hidden) const {
  const auto& corners = all_triangles_ ? all_triangles_->corners : surface_.triangles;
  const auto& uv = all_triangles_ ? all_triangles_->uv : surface_.triangle_uv;
  if (hidden.empty()) return {corners, uv};
  if (hidden.size() != corners.size()) throw ContractError("triangles to hide must be one for each");
  Triangles shown;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (hidden[i]) continue;
    shown.corners.push_back(corners[i]);
    if (!uv.empty()) shown.uv.push_back(uv[i]);
  }
  return shown;
}

void SculptedSurface::hide(const std::vector<bool>& hidden) {
  if (!replaced_.empty() || !undone_replaced_.empty())
    throw Error("triangles cannot be hidden while a stroke that replaced some can be undone");
  Triangles shown = shown_triangles(hidden);
  if (std::ranges::none_of(shown.corners, [&](const Triangle& t) { return has_area(surface_.positions, t); }))
    throw Error("no triangle with an area would be left to draw on");
  if (!all_triangles_) all_triangles_ = {std::move(surface_.triangles), std::move(surface_.triangle_uv)};
  if (shown.corners.size() == all_triangles_->corners.size()) all_triangles_.reset();
  surface_.triangles = std::move(shown.corners);
  surface_.triangle_uv = std::move(shown.uv);
  connect_surface(surface_);
  picker_ = Picker(surface_);
  shown_ = ShownSurface(surface_);
  builders_ = std::make_unique<ChartBuilders>(surface_, picker_);
  note_all_changed();
}

void SculptedSurface::require_all_shown() const {
  if (all_triangles_) throw Error("a surface with hidden triangles cannot be given others");
}

void SculptedSurface::show(const VertexMoves& moves) {
  const std::span<const Index> moved = shown_.move(surface_, moves.vertices, moves.positions);
  std::vector<Index> painted;
  if (!moves.tints.empty()) paint_.set(moves.vertices, moves.tints, painted);
  std::ranges::sort(painted);
  note_changed(moved, painted);
}

void SculptedSurface::drop() {
  if (unrefined_) {
    exchange(std::move(unrefined_->painted), std::move(unrefined_->kept));
    unrefined_.reset();
    return;
  }
  const std::vector<Index> displaced = shown_.take_displaced(surface_);
  std::vector<Vec3f> bases;
  bases.reserve(displaced.size());
  for (const Index vertex : displaced) bases.push_back(surface_.positions[vertex]);
  note_changed(shown_.move(surface_, displaced, bases), paint_.drop());
  shown_.take_displaced(surface_);
}

void SculptedSurface::keep(MadePart made, KeptEdges kept) {
  const std::vector<Index> displaced = shown_.take_displaced(surface_);
  PaintStep painted = paint_.commit();
  state_.repainted(surface_, painted, paint_.base());
  given_.exchange(kept);
  if (unrefined_) {
    UndoStep step;
    step.made = made;
    step.refined = true;
    record_replaced(*std::exchange(unrefined_, std::nullopt), std::move(step));
  } else {
    UndoStep step;
    step.paint = std::move(painted);
    step.made = made;
    step.noted = std::move(kept.vertices);
    step.notes = std::move(kept.edges);
    journal_.record(displaced, surface_.positions, std::move(step));
  }
  end_redoing();
  commit(displaced);
}

/// How many vertices, by their numbers in the source, are the same in a patched surface.
Index SculptedSurface::same_numbers(const PaintedPatch& made) const {
  const std::vector<Index>& source = made.painted.surface.source_vertex;
  auto same = static_cast<Index>(source.size());
  for (std::size_t v = 0; v < source.size(); ++v) {
    const Index from = made.came_from[v];
    if (from >= surface_.vertex_count() || surface_.source_vertex[from] != source[v])
      same = std::min(same, source[v]);
  }
  return same;
}

void SculptedSurface::keep_coarser(MadePart made, PathCoarsening coarser) {
  PaintedPatch patch = with_patch(coarser.drawn, picker_, paint_.shown(), coarser.patch);
  std::vector<Index> corners;
  for (const Index triangle : coarser.patch.removed)
    corners.insert(corners.end(), surface_.triangles[triangle].begin(), surface_.triangles[triangle].end());
  sort_unique(corners);
  GivenShape given = given_;
  given.exchange(coarser.kept);
  given = given.coarsened(patch.painted.surface, patch.came_from, corners);
  const Index same = same_numbers(patch);
  Replaced replaced = exchange(std::move(patch.painted), {nullptr, std::move(given), same});
  UndoStep step;
  step.made = made;
  step.refined = true;
  if (unrefined_) {
    replaced = *std::exchange(unrefined_, std::nullopt);
    replaced.kept.same = std::min(replaced.kept.same, same);
  }
  record_replaced(std::move(replaced), std::move(step));
  end_redoing();
}

void SculptedSurface::replace(PaintedPatch made) {
  GivenShape given = given_.patched(made.painted.surface, made.came_from, {});
  Replaced replaced = exchange(std::move(made.painted), {nullptr, std::move(given), 0});
  UndoStep step;
  step.merged = true;
  step.refined = is_refined();
  if (unrefined_) replaced = *std::exchange(unrefined_, std::nullopt);
  replaced.kept.same = 0;
  record_replaced(std::move(replaced), std::move(step));
  end_redoing();
}

void SculptedSurface::refine(PaintedPatch made, const AddedVertices& added) {
  GivenShape given = given_.patched(made.painted.surface, made.came_from, added);
  const Index same = surface_.vertex_count();
  Replaced replaced = exchange(std::move(made.painted), {nullptr, std::move(given), same});
  if (!unrefined_) unrefined_ = std::move(replaced);
}

/// Records the step that brings a surface back; what belongs to it is kept for that.
void SculptedSurface::record_replaced(Replaced replaced, UndoStep step) {
  replaced.kept.builders->free_strokes();
  replaced_.push_back(std::move(replaced.kept));
  step.surface = std::move(replaced.painted.surface);
  step.surface_paint = std::move(replaced.painted.paint);
  journal_.record(std::move(step));
}

void SculptedSurface::end_redoing() {
  undone_.clear();
  undone_replaced_.clear();
  drop_oldest();
}

void SculptedSurface::limit_undo(std::size_t bytes) {
  most_undo_bytes_ = bytes;
  drop_oldest();
}

void SculptedSurface::drop_oldest() {
  for (; journal_.size() > 0 && undo_bytes() > most_undo_bytes_; ++undo_dropped_)
    if (journal_.drop_oldest().surface) replaced_.erase(replaced_.begin());
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
  std::vector<Kept>& of_turn = kept_of(turn);
  Kept back = std::move(of_turn.back());
  of_turn.pop_back();
  Replaced replaced = exchange({std::move(*step.surface), std::move(step.surface_paint)}, std::move(back));
  replaced.kept.builders->free_strokes();
  kept_of(turn == Turn::undo ? Turn::redo : Turn::undo).push_back(std::move(replaced.kept));
  step.surface = std::move(replaced.painted.surface);
  step.surface_paint = std::move(replaced.painted.paint);
  return step;
}

UndoStep SculptedSurface::restore_vertices(UndoStep step) {
  for (std::size_t i = 0; i < step.vertices.size(); ++i)
    step.positions[i] = surface_.positions[step.vertices[i]];
  commit(step.vertices);
  KeptEdges kept{std::move(step.noted), std::move(step.notes)};
  given_.exchange(kept);
  step.noted = std::move(kept.vertices);
  step.notes = std::move(kept.edges);
  step.paint = paint_.restore(step.paint);
  state_.repainted(surface_, step.paint, paint_.base());
  return step;
}

std::optional<StrokeStep> SculptedSurface::release_step() {
  const UndoStep* newest = journal_.newest();
  if (!newest) return std::nullopt;
  if (newest->surface || newest->made != MadePart::none)
    throw Error("the last stroke made triangles or parts, so that its step stays with the session");
  StrokeStep step;
  step.from = state();
  step.to = state_.with(*newest, surface_, paint_.base());
  release_values(*journal_.take(), surface_.source_vertex, step);
  return step;
}

void SculptedSurface::apply(StrokeStep& step) {
  if (state() != step.from) throw Error("the surface is not in the state that the step belongs to");
  if (of_source_.empty()) of_source_ = numbers_of_source(surface_);
  UndoStep values = values_for(step, of_source_);
  show(values);
  release_values(restore_vertices(std::move(values)), surface_.source_vertex, step);
  std::swap(step.from, step.to);
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
  for (const Index vertex : displaced)
    state_.moved(surface_.source_vertex[vertex], surface_.positions[vertex], shown_.positions()[vertex]);
  shown_.commit(surface_, displaced);
  picker_.update(displaced);
  builders_->moved(displaced, std::sqrt(static_cast<double>(farthest)));
}

std::span<const Index> SculptedSurface::note_all_changed() {
  changed_.resize(surface_.vertex_count());
  std::iota(changed_.begin(), changed_.end(), Index{0});
  return changed_;
}

/// Makes all that depends on the surface anew, but for chart builders that are given. Returns what was there.
SculptedSurface::Replaced SculptedSurface::exchange(PaintedSurface made, Kept kept) {
  Paint paint = paint_.exchange(made.surface.vertex_count(), std::move(made.paint));
  Replaced replaced{{std::move(surface_), std::move(paint)},
                    {std::move(builders_), std::move(given_), kept.same}};
  surface_ = std::move(made.surface);
  picker_ = Picker(surface_);
  shown_ = ShownSurface(surface_);
  builders_ = kept.builders ? std::move(kept.builders) : std::make_unique<ChartBuilders>(surface_, picker_);
  state_.reset();
  of_source_.clear();
  given_ = std::move(kept.given);
  kept_vertices_ = std::min(kept_vertices_, kept.same);
  ++generation_;
  note_all_changed();
  return replaced;
}

}  // namespace burin
