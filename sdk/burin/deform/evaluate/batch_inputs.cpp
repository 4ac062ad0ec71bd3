// Fills the inputs that a brush declares, column by column, from the chart, the surface, its paint, the pen
// and earlier passes. An input costs O(1) per node; footprints, curvatures and Laplacians cost O(valence).
#include <burin/deform/evaluate/batch.h>
#include <burin/deform/evaluate/displacement.h>
#include <burin/surface/topology/surroundings.h>

#include <algorithm>

namespace burin {
namespace {

constexpr float zero = 0, one = 1;

burin_floats uniform(const float& value) { return {&value, 0, 0}; }

}  // namespace

template <class Value>
burin_floats Batch::numbers(std::span<const Index> nodes, const Value& value) {
  float* column = next_column();
  for (std::size_t i = 0; i < nodes.size(); ++i) column[i] = value(nodes[i]);
  return {column, 1, 0};
}

template <class Value>
burin_indices Batch::numbers(std::span<const Index> nodes, std::vector<std::uint32_t>& column,
                             const Value& value) {
  for (std::size_t i = 0; i < nodes.size(); ++i) column[i] = value(nodes[i]);
  return {column.data(), 1, 0};
}

template <class Value>
burin_vectors Batch::vectors(std::size_t count, const Value& value) {
  float *x = next_column(), *y = next_column(), *z = next_column();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3f vector = value(i);
    x[i] = vector.x();
    y[i] = vector.y();
    z[i] = vector.z();
  }
  return {{x, 1, 0}, {y, 1, 0}, {z, 1, 0}};
}

void Batch::fill_chart(std::uint64_t inputs, std::span<const Index> nodes) {
  const Chart& chart = source_->nodes.chart();
  if (inputs & BURIN_INPUT_T) {
    batch_.t = numbers(nodes, [&](Index node) {
      return source_->dab_t.empty() ? static_cast<float>(chart.t[node]) : source_->dab_t[node];
    });
  }
  if (inputs & BURIN_INPUT_D) {
    batch_.d = numbers(nodes, [&](Index node) { return mirrored_ ? -chart.d[node] : chart.d[node]; });
  }
  if (inputs & BURIN_INPUT_E1)
    batch_.e1 = vectors(nodes.size(), [&](std::size_t i) {
      const CurrentBase::Geometry* geometry = current(nodes[i]);
      return geometry ? geometry->e1 : chart.e1[nodes[i]];
    });
  if (inputs & BURIN_INPUT_STRETCH)
    batch_.stretch = numbers(nodes, [&](Index node) { return chart.stretch[node]; });
}

void Batch::fill_radius(std::uint64_t inputs, std::span<const Index> nodes) {
  radius_ = source_->radius;
  if (!(inputs & BURIN_INPUT_RADIUS)) return;
  const std::vector<float>& half_width = source_->nodes.half_width();
  batch_.radius =
      half_width.empty() ? uniform(radius_) : numbers(nodes, [&](Index node) { return half_width[node]; });
}

void Batch::fill_positions(std::uint64_t inputs, std::span<const Index> nodes,
                           std::span<const Vec3f> displacement) {
  const Chart& chart = source_->nodes.chart();
  if (inputs & BURIN_INPUT_POSITION) {
    batch_.position = vectors(nodes.size(), [&](std::size_t i) -> Vec3f {
      if (const CurrentBase::Geometry* geometry = current(nodes[i])) return geometry->position;
      return after_pass_before(source_->base_position(vertex(nodes[i])), nodes[i], displacement, i);
    });
  }
  if (inputs & BURIN_INPUT_NORMAL)
    batch_.normal = vectors(nodes.size(), [&](std::size_t i) {
      const CurrentBase::Geometry* geometry = current(nodes[i]);
      return geometry ? geometry->normal : chart.normal[nodes[i]];
    });
  if (!(inputs & BURIN_INPUT_DISPLACEMENT)) return;
  batch_.displacement =
      displacement.empty()
          ? burin_vectors{uniform(zero), uniform(zero), uniform(zero)}
          : vectors(nodes.size(), [&](std::size_t i) { return in_brush_frame(displacement[i]); });
}

void Batch::fill_fine(std::uint64_t inputs, std::span<const Index> nodes,
                      std::span<const Vec3f> displacement) {
  const Surface& surface = source_->surface;
  if (inputs & BURIN_INPUT_FINE_POSITION)
    batch_.fine_position = vectors(nodes.size(), [&](std::size_t i) -> Vec3f {
      if (const CurrentBase::Geometry* geometry = current(nodes[i])) return geometry->fine_position;
      return after_pass_before(surface.positions[vertex(nodes[i])], nodes[i], displacement, i);
    });
  if (inputs & BURIN_INPUT_FINE_NORMAL)
    batch_.fine_normal = vectors(nodes.size(), [&](std::size_t i) {
      const CurrentBase::Geometry* geometry = current(nodes[i]);
      return geometry ? geometry->fine_normal : surface.normals[vertex(nodes[i])];
    });
  if (inputs & BURIN_INPUT_FINE_MEAN_CURVATURE)
    batch_.fine_mean_curvature =
        numbers(nodes, [&](Index node) { return mean_curvature(surface, vertex(node)); });
}

/// A position of nodes[i], displaced by the result of the previous pass, if there is one.
Vec3f Batch::after_pass_before(const Vec3f& position, Index node, std::span<const Vec3f> displacement,
                               std::size_t i) const {
  if (displacement.empty()) return position;
  const Chart& chart = source_->nodes.chart();
  return displaced(position, chart.e1[node], chart.normal[node], displacement[i]);
}

/// Converts components along (e1, e2, n) between the node's frame and the brush's, which is mirrored in
/// mirrored instances.
Vec3f Batch::in_brush_frame(const Vec3f& components) const {
  return mirrored_ ? Vec3f(components.x(), -components.y(), components.z()) : components;
}

void Batch::fill_surroundings(std::uint64_t inputs, std::span<const Index> nodes) {
  const Chart& chart = source_->nodes.chart();
  const Surface& surface = source_->surface;
  if (inputs & BURIN_INPUT_FOOTPRINT) {
    // A step of length u along e1 changes t by u / J.
    batch_.footprint_t = numbers(nodes, [&](Index node) {
      return cell_size(surface, vertex(node), chart.e1[node]) / std::max(chart.stretch[node], least_stretch);
    });
    batch_.footprint_d = numbers(nodes, [&](Index node) {
      const Index at = vertex(node);
      return cell_size(surface, at, chart.normal[node].cross(chart.e1[node]));
    });
  }
  if (inputs & BURIN_INPUT_MEAN_CURVATURE)
    batch_.mean_curvature = numbers(nodes, [&](Index node) {
      return source_->base ? base_mean_curvature(*source_->base, surface, vertex(node))
                           : mean_curvature(surface, vertex(node));
    });
  if (!(inputs & BURIN_INPUT_LAPLACIAN)) return;
  const PassPositions* before = source_->before;
  batch_.laplacian = vectors(nodes.size(), [&](std::size_t i) -> Vec3f {
    if (const CurrentBase::Geometry* geometry = current(nodes[i])) return geometry->laplacian;
    return umbrella(surface, vertex(nodes[i]),
                    [&](Index at) { return before ? (*before)[at] : surface.positions[at]; });
  });
}

void Batch::fill_paint(std::uint64_t inputs, std::span<const Index> nodes) {
  const Paint& paint = source_->painted();
  if (inputs & BURIN_INPUT_MASK) {
    batch_.mask = paint.mask.empty() ? uniform(one)
                                     : numbers(nodes, [&](Index node) { return paint.mask[vertex(node)]; });
  }
  if (!(inputs & BURIN_INPUT_COLOUR)) return;
  const auto channel = [&](int k) {
    return numbers(nodes, [&](Index node) { return paint.colour_of(vertex(node))[k]; });
  };
  batch_.colour = {channel(0), channel(1), channel(2), channel(3)};
}

void Batch::fill_foot(std::uint64_t inputs, std::span<const Index> nodes) {
  if (!(inputs & BURIN_INPUT_FOOT)) return;
  std::vector<FootPlane> planes;
  planes.reserve(nodes.size());
  for (const Index node : nodes) planes.push_back(source_->foot->at(source_->nodes.chart().t[node]));
  batch_.foot = vectors(nodes.size(), [&](std::size_t i) { return planes[i].position; });
  batch_.foot_normal = vectors(nodes.size(), [&](std::size_t i) { return planes[i].normal; });
}

void Batch::fill_end_distance(std::uint64_t inputs, std::span<const Index> nodes) {
  if (!(inputs & BURIN_INPUT_END_DISTANCE)) return;
  const std::vector<float>& distance = source_->nodes.end_distance();
  batch_.end_distance = numbers(nodes, [&](Index node) { return distance[node]; });
}

void Batch::fill_pen(std::uint64_t inputs, std::span<const Index> nodes) {
  const std::vector<NodePen>& pen = source_->nodes.pen();
  const auto field = [&](std::uint64_t input, float NodePen::*member, const float& neutral) {
    if (!(inputs & input)) return burin_floats{};
    if (pen.empty()) return uniform(neutral);
    return numbers(nodes, [&](Index node) { return pen[node].*member; });
  };
  batch_.pressure = field(BURIN_INPUT_PRESSURE, &NodePen::pressure, one);
  batch_.tilt_x = field(BURIN_INPUT_TILT, &NodePen::tilt_x, zero);
  batch_.tilt_y = field(BURIN_INPUT_TILT, &NodePen::tilt_y, zero);
  batch_.twist = field(BURIN_INPUT_TWIST, &NodePen::twist, zero);
  batch_.speed = field(BURIN_INPUT_SPEED, &NodePen::speed, zero);
  batch_.time = field(BURIN_INPUT_TIME, &NodePen::time, zero);
}

void Batch::fill_names(std::uint64_t inputs, std::span<const Index> nodes) {
  const Chart& chart = source_->nodes.chart();
  if (inputs & BURIN_INPUT_SHEET)
    batch_.sheet = numbers(nodes, sheets_, [&](Index node) { return chart.sheet[node]; });
  if (inputs & BURIN_INPUT_VISIT_COUNT) {
    batch_.visit_count = numbers(nodes, visit_counts_,
                                 [&](Index node) { return source_->nodes.live().sheet_count(vertex(node)); });
  }
  if (inputs & BURIN_INPUT_NODE_ID)
    batch_.node_id =
        numbers(nodes, node_ids_, [&](Index node) { return source_->surface.source_vertex[vertex(node)]; });
  if (!(inputs & BURIN_INPUT_SYMMETRY)) return;
  symmetry_ = source_->symmetry;
  batch_.symmetry = {&symmetry_, 0, 0};
}

}  // namespace burin
