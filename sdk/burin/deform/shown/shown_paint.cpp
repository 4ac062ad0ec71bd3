// Keeps the shown paint beside the paint before the stroke, and a list of the vertices that were set, so that
// commit() and drop() cost O(k log k) for k of them, whatever the size of the surface.
#include <burin/abi/stroke.h>
#include <burin/base/sort_unique.h>
#include <burin/deform/shown/shown_paint.h>

#include <utility>

namespace burin {

void ShownPaint::assign(Paint paint) {
  base_ = std::move(paint);
  shown_ = base_;
}

void ShownPaint::prepare(std::uint64_t outputs) {
  for (Paint* paint : {&base_, &shown_}) {
    if (outputs & BURIN_OUTPUT_COLOUR && paint->colour.empty())
      paint->colour.assign(vertex_count_, Paint::bare());
    if (outputs & BURIN_OUTPUT_MASK && paint->mask.empty()) paint->mask.assign(vertex_count_, 1);
  }
}

void ShownPaint::set(std::span<const Index> vertices, std::span<const Tint> tints,
                     std::vector<Index>& changed) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Index vertex = vertices[i];
    const Vec4f before = base_.colour_of(vertex), showing = shown_.colour_of(vertex);
    const float mask_showing = shown_.mask_of(vertex);
    const bool as_before = tints[i].head<4>() == tint_of(before, 1).head<4>();
    const Vec4f colour = as_before ? before : colour_of(tints[i]);
    if (colour == showing && tints[i][4] == mask_showing) continue;
    if (!shown_.colour.empty()) shown_.colour[vertex] = colour;
    if (!shown_.mask.empty()) shown_.mask[vertex] = tints[i][4];
    touched_.push_back(vertex);
    changed.push_back(vertex);
  }
}

PaintStep ShownPaint::commit() {
  PaintStep before;
  for (const Index vertex : take_touched()) {
    const bool same = base_.colour_of(vertex) == shown_.colour_of(vertex) &&
                      base_.mask_of(vertex) == shown_.mask_of(vertex);
    if (same) continue;
    before.vertices.push_back(vertex);
    if (!base_.colour.empty())
      before.colours.push_back(std::exchange(base_.colour[vertex], shown_.colour[vertex]));
    if (!base_.mask.empty()) before.masks.push_back(std::exchange(base_.mask[vertex], shown_.mask[vertex]));
  }
  return before;
}

std::vector<Index> ShownPaint::drop() {
  std::vector<Index> vertices = take_touched();
  for (const Index vertex : vertices) {
    if (!shown_.colour.empty()) shown_.colour[vertex] = base_.colour[vertex];
    if (!shown_.mask.empty()) shown_.mask[vertex] = base_.mask[vertex];
  }
  return vertices;
}

PaintStep ShownPaint::restore(const PaintStep& step) {
  // The step may hold colours or masks although a paint without them was assigned since.
  prepare((step.colours.empty() ? 0 : BURIN_OUTPUT_COLOUR) | (step.masks.empty() ? 0 : BURIN_OUTPUT_MASK));
  PaintStep replaced = step;
  for (std::size_t i = 0; i < step.colours.size(); ++i) {
    const Index vertex = step.vertices[i];
    replaced.colours[i] = base_.colour[vertex];
    base_.colour[vertex] = shown_.colour[vertex] = step.colours[i];
  }
  for (std::size_t i = 0; i < step.masks.size(); ++i) {
    const Index vertex = step.vertices[i];
    replaced.masks[i] = base_.mask[vertex];
    base_.mask[vertex] = shown_.mask[vertex] = step.masks[i];
  }
  return replaced;
}

std::vector<Index> ShownPaint::take_touched() {
  std::vector<Index> vertices = std::exchange(touched_, {});
  sort_unique(vertices);
  return vertices;
}

}  // namespace burin
