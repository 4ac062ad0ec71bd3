// Meshes are scaled so that their width is the stroke's, laid along it as if it were straight, and bent: at
// arc length t the section (a across, u up) is turned by the twist about its middle, made as narrow as the
// stroke is there, lifted, and put at (t, d, h) by the shell over the base surface.
#include <burin/along/along_parts.h>
#include <burin/along/join_copies.h>
#include <burin/along/laid_mesh.h>
#include <burin/along/refine_bent.h>
#include <burin/along/shell_map.h>
#include <burin/base/error.h>
#include <burin/math/elementary.h>
#include <burin/surface/mesh_file.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace burin {
namespace {

constexpr std::size_t most_triangles = 20000000;

SourcePart part_of(const MeshSource& source, const AlongSettings& axes) {
  if (source.mesh) return {*source.mesh, axes};
  const PolygonMesh mesh = read_mesh(source.file);
  try {
    return {mesh, axes};
  } catch (const Error& error) {
    throw FileError(source.file, error.what());
  }
}

std::optional<SourcePart> part_if_given(const MeshSource& source, const AlongSettings& axes) {
  if (!source.given()) return {};
  return part_of(source, axes);
}

/// The section at an arc length: how far it is turned, narrowed and lifted. Object units.
struct Section {
  double turns_over_length = 0;  ///< per object unit
  double axis = 0;               ///< height of the line about which it is turned, over the lowest point
  double lift = 0;

  Vec2d at(double t, double across, double up, double width) const {
    const double angle = 2 * std::numbers::pi * turns_over_length * t;
    const double cosine = math::cos(angle), sine = math::sin(angle), above = up - axis;
    return width * Vec2d(cosine * across + sine * above, axis + lift - sine * across + cosine * above);
  }
};

const SourcePart& part_at(const CopyInterval& interval, const SourcePart& middle,
                          const std::optional<SourcePart>& start, const std::optional<SourcePart>& end) {
  if (interval.part == CopyInterval::Part::start) return *start;
  return interval.part == CopyInterval::Part::end ? *end : middle;
}

void turn_over(TriangleMesh& mesh) {
  for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  for (TriangleUv& uv : mesh.triangle_uv) std::swap(uv[1], uv[2]);
}

}  // namespace

AlongParts::AlongParts(const AlongSettings& settings)
    : settings_(settings),
      middle_(part_of(settings.middle, settings)),
      start_(part_if_given(settings.start, settings)),
      end_(part_if_given(settings.end, settings)) {
  settings_.middle = settings_.start = settings_.end = {};
  const std::array<const SourcePart*, 3> parts{&middle_, start_ ? &*start_ : nullptr,
                                               end_ ? &*end_ : nullptr};
  for (const SourcePart* part : parts) {
    if (!part) continue;
    half_width_ = std::max(half_width_, widest(*part));
    with_uv_ = with_uv_ || !part->triangle_uv.empty();
  }
  // An upright sheet has no width, but a height.
  if (!(half_width_ > 0)) half_width_ = middle_.box.sizes().z() / 2;
  if (!(half_width_ > 0)) throw Error("the mesh along the stroke has no width");
}

/// The farthest that a part reaches across from the middle of the repeated one, turned if there is a twist.
double AlongParts::widest(const SourcePart& part) const {
  const Vec3d middle = middle_.box.center();
  double farthest = 0;
  for (const Triangle& triangle : part.triangles) {
    for (const Index vertex : triangle) {
      const Vec3d from = part.points[vertex] - middle;
      const double reach = settings_.twist == 0 ? std::abs(from.y()) : math::hypot(from.y(), from.z());
      farthest = std::max(farthest, reach);
    }
  }
  return farthest;
}

TriangleMesh AlongParts::bend(const BentStroke& stroke) const {
  const Chart& chart = stroke.ground.chart;
  const double scale = stroke.radius / half_width_;
  const auto length_of = [&](const std::optional<SourcePart>& part) {
    return part ? scale * part->length() : 0;
  };
  const double most = static_cast<double>(most_triangles) / static_cast<double>(middle_.triangles.size());
  const std::vector<CopyInterval> intervals = lay_copies({.start = chart.closed ? 0 : length_of(start_),
                                                          .middle = scale * middle_.length(),
                                                          .end = chart.closed ? 0 : length_of(end_),
                                                          .stroke = chart.length,
                                                          .spacing = settings_.spacing * stroke.radius,
                                                          .closed = chart.closed},
                                                         most);
  if (intervals.empty()) return {};
  LaidMesh laid;
  const LaidFrame frame{middle_.box.center().y(), middle_.box.min().z(), scale};
  for (const CopyInterval& interval : intervals)
    lay(part_at(interval, middle_, start_, end_), interval, frame, with_uv_, laid);
  const double turns = chart.closed ? std::round(settings_.twist) : settings_.twist;
  const Section section{turns / chart.length, scale * middle_.box.sizes().z() / 2,
                        settings_.height * stroke.radius};
  const ShellMap map(stroke.ground);
  const auto bend = [&](const Vec3d& point) {
    const double t =
        chart.closed ? point.x() - chart.length * std::floor(point.x() / chart.length) : point.x();
    const Vec2d bent = section.at(t, point.y(), point.z(), stroke.width ? stroke.width(t) : 1);
    return map(t, stroke.mirrored ? -bent.x() : bent.x(), bent.y());
  };
  const BendTolerance tolerance{stroke.radius / 500, stroke.radius / 200, most_triangles};
  const std::vector<Vec3d> bent = refine_bent(laid, bend, tolerance);
  TriangleMesh mesh = joined_copies(std::move(laid), bent, intervals, chart.closed ? chart.length : 0);
  if (stroke.mirrored) turn_over(mesh);
  return mesh;
}

}  // namespace burin
