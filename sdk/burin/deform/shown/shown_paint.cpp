// Keeps the shown paint beside the paint before the stroke, and a list of the vertices that were set, so that
// commit() and drop() cost O(k log k) for k of them, whatever the size of the surface. Arrays that have only
// bare values again are put away for the next stroke, in O(1).
#include <burin/abi/stroke.h>
#include <burin/base/sort_unique.h>
#include <burin/deform/shown/shown_paint.h>

#include <algorithm>
#include <utility>

namespace burin {

namespace {

/// Writes a value; returns the one before. `painted` counts values that are not bare.
template <class Value>
Value replace(Value& value, const Value& by, const Value& bare, std::size_t& painted) {
  if (value != bare) --painted;
  if (by != bare) ++painted;
  return std::exchange(value, by);
}

template <class Value>
std::size_t count_painted(const std::vector<Value>& values, const Value& bare) {
  return static_cast<std::size_t>(
      std::ranges::count_if(values, [&](const Value& value) { return value != bare; }));
}

}  // namespace

void ShownPaint::assign(Paint paint) {
  // What strokes painted before is no less theirs because it is assigned with the rest.
  const auto assigned = [](const auto& now, const auto& before, bool already) {
    return !now.empty() && (already || now != before);
  };
  colours_.assigned = assigned(paint.colour, base_.colour, colours_.assigned);
  masks_.assigned = assigned(paint.mask, base_.mask, masks_.assigned);
  set_all(std::move(paint));
}

Paint ShownPaint::exchange(Index vertex_count, Paint paint) {
  put_away();
  vertex_count_ = vertex_count;
  touched_.clear();
  Paint before = std::move(base_);
  set_all(std::move(paint));
  return before;
}

void ShownPaint::set_all(Paint paint) {
  colours_ = {Paint::bare(), colours_.assigned, count_painted(paint.colour, Paint::bare())};
  masks_ = {1, masks_.assigned, count_painted(paint.mask, 1.0F)};
  base_ = std::move(paint);
  shown_ = base_;
  put_away();
}

template <class Value>
void ShownPaint::prepare(std::vector<Value> Paint::*values, Kind<Value>& kind) {
  if (!(base_.*values).empty()) return;
  (base_.*values).swap(kind.base);
  (shown_.*values).swap(kind.shown);
  (base_.*values).resize(vertex_count_, kind.bare);
  (shown_.*values).resize(vertex_count_, kind.bare);
}

void ShownPaint::prepare(std::uint64_t outputs) {
  if (outputs & BURIN_OUTPUT_COLOUR) prepare(&Paint::colour, colours_);
  if (outputs & BURIN_OUTPUT_MASK) prepare(&Paint::mask, masks_);
}

template <class Value>
void ShownPaint::put_away(std::vector<Value> Paint::*values, Kind<Value>& kind) {
  if (kind.assigned || kind.painted > 0 || (base_.*values).empty()) return;
  (base_.*values).swap(kind.base);
  (shown_.*values).swap(kind.shown);
}

/// Puts away arrays that only strokes made which are taken back.
void ShownPaint::put_away() {
  put_away(&Paint::colour, colours_);
  put_away(&Paint::mask, masks_);
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
      before.colours.push_back(
          replace(base_.colour[vertex], shown_.colour[vertex], colours_.bare, colours_.painted));
    if (!base_.mask.empty())
      before.masks.push_back(replace(base_.mask[vertex], shown_.mask[vertex], masks_.bare, masks_.painted));
  }
  put_away();
  return before;
}

std::vector<Index> ShownPaint::drop() {
  std::vector<Index> vertices = take_touched();
  for (const Index vertex : vertices) {
    if (!shown_.colour.empty()) shown_.colour[vertex] = base_.colour[vertex];
    if (!shown_.mask.empty()) shown_.mask[vertex] = base_.mask[vertex];
  }
  put_away();
  return vertices;
}

PaintStep ShownPaint::restore(const PaintStep& step) {
  // The step may hold colours or masks although a paint without them was assigned since.
  prepare((step.colours.empty() ? 0 : BURIN_OUTPUT_COLOUR) | (step.masks.empty() ? 0 : BURIN_OUTPUT_MASK));
  PaintStep replaced = step;
  for (std::size_t i = 0; i < step.colours.size(); ++i) {
    const Index vertex = step.vertices[i];
    replaced.colours[i] = replace(base_.colour[vertex], step.colours[i], colours_.bare, colours_.painted);
    shown_.colour[vertex] = step.colours[i];
  }
  for (std::size_t i = 0; i < step.masks.size(); ++i) {
    const Index vertex = step.vertices[i];
    replaced.masks[i] = replace(base_.mask[vertex], step.masks[i], masks_.bare, masks_.painted);
    shown_.mask[vertex] = step.masks[i];
  }
  put_away();
  return replaced;
}

std::vector<Index> ShownPaint::take_touched() {
  std::vector<Index> vertices = std::exchange(touched_, {});
  sort_unique(vertices);
  return vertices;
}

}  // namespace burin
