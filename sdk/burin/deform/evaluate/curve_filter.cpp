// Asks a brush for the offsets of a curve's points and checks them. The brush is given the points from its
// reach behind the first requested one to the end of the curve.
#include <burin/base/error.h>
#include <burin/deform/evaluate/curve_filter.h>
#include <burin/deform/evaluate/error_text.h>
#include <burin/math/elementary.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace burin {
namespace {

/// The longest offset, in radii.
constexpr double farthest = 100;

/// Columns of the points of a curve, as the ABI has them.
class PointColumns {
 public:
  explicit PointColumns(std::span<const CurvePoint> points) : count_(points.size()) {
    for (std::vector<float>& column : columns_) column.reserve(count_);
    for (const CurvePoint& point : points) {
      columns_[0].push_back(static_cast<float>(point.t));
      add(1, point.at.position);
      add(4, point.normal);
      add(7, point.tangent);
    }
  }

  burin_curve_points abi() const {
    return {sizeof(burin_curve_points),
            static_cast<std::uint32_t>(count_),
            column(0),
            vectors(1),
            vectors(4),
            vectors(7)};
  }

 private:
  void add(std::size_t first, const Vec3f& vector) {
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      columns_[first + static_cast<std::size_t>(axis)].push_back(vector[axis]);
  }
  burin_floats column(std::size_t i) const { return {columns_[i].data(), 1, 0}; }
  burin_vectors vectors(std::size_t first) const {
    return {column(first), column(first + 1), column(first + 2)};
  }

  std::size_t count_;
  std::array<std::vector<float>, 10> columns_;
};

}  // namespace

std::optional<CurveFilter> CurveFilter::of(const BrushStroke& stroke, const burin_stroke_context& context) {
  const auto* filter = static_cast<const burin_curve_filter*>(stroke.extension(BURIN_EXT_CURVE_FILTER));
  if (!filter || !BURIN_HAS(filter, burin_curve_filter, filter)) return {};
  CurveFilter made(stroke, *filter, context);
  const char* id = stroke.descriptor().id;
  burin_curve_reach reach{sizeof(burin_curve_reach), 0, 0, 0};
  const PluginCall call("brush", id);
  filter->reach(stroke.brush(), stroke.handle(), &reach);
  // The comparison is also false for NaN.
  if (!(reach.behind >= 0 && reach.ahead >= 0))
    throw ContractError(
        fmt::format("{}: moves curves by what is {} behind and {} ahead", id, reach.behind, reach.ahead));
  made.reach_ = {reach.behind, reach.ahead};
  return made;
}

std::vector<CurveOffset> CurveFilter::offsets(const SurfaceCurve& drawn, std::size_t first,
                                              std::uint64_t flags) const {
  const std::span<const CurvePoint> points = drawn.points;
  if (first >= points.size()) return {};
  const auto begin = std::ranges::lower_bound(points, points[first].t - reach_.behind, {}, &CurvePoint::t);
  const PointColumns part(points.subspan(static_cast<std::size_t>(begin - points.begin())));
  const burin_curve_points abi = part.abi();
  std::vector<float> along(abi.count), across(abi.count);
  burin_stroke_context context = context_;
  context.flags |= flags | (drawn.closed ? BURIN_STROKE_CLOSED : 0);
  context.length = drawn.length();
  const char* id = stroke_->descriptor().id;
  ErrorText error;
  const PluginCall call("brush", id);
  const burin_status status =
      filter_->filter(stroke_->brush(), stroke_->handle(), &context, &stroke_->params(), &abi,
                      {along.data(), 1, 0}, {across.data(), 1, 0}, error.abi());
  if (status != BURIN_OK) throw ContractError(fmt::format("{}: {}", id, error.line(status)));
  const float side = flags & BURIN_STROKE_MIRRORED ? -1.0F : 1.0F;
  std::vector<CurveOffset> offsets;
  const std::size_t wanted = points.size() - first;
  for (std::size_t i = abi.count - wanted; i < abi.count; ++i) {
    offsets.push_back({along[i], side * across[i]});
    check(points[points.size() - abi.count + i], offsets.back());
  }
  return offsets;
}

void CurveFilter::check(const CurvePoint& point, const CurveOffset& offset) const {
  const double length = math::hypot(double{offset.along}, double{offset.across});
  // The comparison is also false for NaN.
  if (length <= farthest * context_.radius_max) return;
  throw ContractError(fmt::format("{}: moves the curve by ({}, {}) at t = {}", stroke_->descriptor().id,
                                  offset.along, offset.across, point.t));
}

}  // namespace burin
