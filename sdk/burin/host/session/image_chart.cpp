// Follows the chart of the original or of the image's own stroke. An event costs O(1) per node that the
// followed chart computed or removed; a vertex's image is searched once.
#include <burin/host/session/image_chart.h>

#include <algorithm>
#include <limits>

namespace burin {
namespace {

/// The greatest distance of an image from a vertex of the surface, in radii.
constexpr double near_enough = 1e-5;

}  // namespace

/// The vertex at the image of this vertex, with the image of its normal; no_index if there is none.
Index ImageChart::image_of(Index vertex) {
  const Vec3f position = moved(surface_->positions[vertex]);
  const auto reach = static_cast<float>(near_enough * radius_);
  const auto at = picker_->closest(position, reach);
  if (!at) return no_index;
  const auto nearest = std::ranges::max_element(at->weights) - at->weights.begin();
  const Index found = at->corners[static_cast<std::size_t>(nearest)];
  const Vec3f normal = turned(surface_->normals[vertex]);
  const bool same = (surface_->positions[found] - position).norm() <= reach &&
                    surface_->normals[found].dot(normal) > 0.9f && taken_.insert(found).second;
  return same ? found : no_index;
}

SurfaceCurve ImageChart::image_of(const SurfaceCurve& original) const {
  SurfaceCurve curve = original;
  for (CurvePoint& point : curve.points) {
    point.at.position = moved(point.at.position);
    point.normal = turned(point.normal);
    point.tangent = turned(point.tangent);
  }
  return curve;
}

void ImageChart::note(const LiveChart& original, Index local) {
  if (images_[local] != no_index) return;
  if (original.first(original.vertex_at(local)) == no_index)
    without_image_.erase(local);
  else
    without_image_.insert(local);
}

bool ImageChart::has_images_of(const LiveChart& original) {
  while (images_.size() < original.local_count())
    images_.push_back(image_of(original.vertex_at(static_cast<Index>(images_.size()))));
  if (!seen_)
    for (Index local = 0; local < original.local_count(); ++local) note(original, local);
  else
    for (const Index vertex : original.altered()) note(original, original.local_index(vertex));
  seen_ = true;
  return without_image_.empty();
}

ChartFrame ImageChart::reflected(const ChartFrame& frame) const {
  ChartFrame image = frame;
  image.e1 = turned(frame.e1);
  if (!image_.mirrored) return image;
  image.d = -frame.d;
  image.curvature = -frame.curvature;
  return image;
}

/// Starts an event. If another chart than before is followed, all slots are removed first.
void ImageChart::begin_following(const LiveChart& chart, Followed kind) {
  const bool other = followed_ != kind;
  const double from = other ? -std::numeric_limits<double>::infinity() : chart.computed_from();
  live_->begin_event(chart.nodes().length, chart.nodes().closed, from);
  if (other)
    for (Index slot = 0; slot < live_->nodes().size(); ++slot) live_->remove(slot);
}

/// Applies the last event of the followed chart, or all of it if another chart was followed before.
/// set_slot(slot) sets a slot of the image's chart.
template <class SetSlot>
void ImageChart::follow(const LiveChart& chart, Followed kind, const SetSlot& set_slot) {
  const bool other = followed_ != kind;
  begin_following(chart, kind);
  followed_ = kind;
  if (other) {
    for (Index slot = 0; slot < chart.nodes().size(); ++slot)
      if (!chart.vacant(slot)) set_slot(slot);
    return;
  }
  for (const Index slot : chart.removed()) live_->remove(slot);
  for (const Index slot : chart.computed())
    if (!chart.vacant(slot)) set_slot(slot);
}

void ImageChart::reflect(const LiveChart& original) {
  const Chart& nodes = original.nodes();
  follow(original, Followed::original, [&](Index slot) {
    const Index vertex = images_[original.local_index_of(slot)];
    live_->set(slot, vertex, reflected(nodes.frame(slot)), turned(nodes.normal[slot]));
  });
}

void ImageChart::copy(const LiveChart& own) {
  const Chart& nodes = own.nodes();
  follow(own, Followed::own,
         [&](Index slot) { live_->set(slot, nodes.vertex[slot], nodes.frame(slot), nodes.normal[slot]); });
}

}  // namespace burin
