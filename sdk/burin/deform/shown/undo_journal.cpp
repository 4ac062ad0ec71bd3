// Stores what strokes changed, in O(changed vertices).
#include <burin/deform/shown/undo_journal.h>

#include <utility>

namespace burin {

namespace {

template <class... Vectors>
std::size_t bytes_in(const Vectors&... vectors) {
  return (std::size_t{0} + ... + (vectors.size() * sizeof(*vectors.data())));
}

std::size_t bytes_of(const UndoStep& step) {
  std::size_t bytes = sizeof step + bytes_in(step.vertices, step.positions) +
                      bytes_in(step.paint.vertices, step.paint.colours, step.paint.masks) +
                      bytes_in(step.surface_paint.colour, step.surface_paint.mask) +
                      bytes_in(step.noted, step.notes);
  if (const std::optional<Surface>& surface = step.surface)
    bytes += bytes_in(surface->positions, surface->normals, surface->triangles, surface->gauss_curvature,
                      surface->triangle_uv, surface->source_vertex, surface->neighbours.offsets,
                      surface->neighbours.items, surface->incident.offsets, surface->incident.items);
  return bytes;
}

}  // namespace

void UndoJournal::record(std::span<const Index> vertices, std::span<const Vec3f> positions_of_surface,
                         UndoStep step) {
  step.vertices.assign(vertices.begin(), vertices.end());
  step.positions.reserve(vertices.size());
  for (const Index vertex : vertices) step.positions.push_back(positions_of_surface[vertex]);
  record(std::move(step));
}

void UndoJournal::record(UndoStep step) {
  bytes_ += bytes_of(step);
  steps_.push_back(std::move(step));
}

std::optional<UndoStep> UndoJournal::take() {
  if (steps_.empty()) return std::nullopt;
  UndoStep step = std::move(steps_.back());
  steps_.pop_back();
  bytes_ -= bytes_of(step);
  return step;
}

UndoStep UndoJournal::drop_oldest() {
  UndoStep step = std::move(steps_.front());
  steps_.pop_front();
  bytes_ -= bytes_of(step);
  return step;
}

void UndoJournal::clear() {
  steps_.clear();
  bytes_ = 0;
}

}  // namespace burin
