// Makes a straight curve and lets brushes that move curves move its points.
#include "validate/probe/straight_curve.h"

#include <cstdint>

namespace burin::validate {

StraightCurve::StraightCurve(std::size_t count) : zero_(count), one_(count, 1.0f) {
  t_.reserve(count);
  for (std::size_t i = 0; i < count; ++i) t_.push_back(static_cast<float>(0.1 * static_cast<double>(i)));
  const burin_floats none{zero_.data(), 1, 0}, unit{one_.data(), 1, 0}, place{t_.data(), 1, 0};
  points_ = {
      sizeof points_,    static_cast<std::uint32_t>(count), place, {place, none, none}, {none, none, unit},
      {unit, none, none}};
}

std::vector<float> offsets(const ProbeBrush& brush, const ProbeStroke& stroke,
                           const burin_curve_filter& filter, const burin_curve_points& points, double length,
                           const std::string& otherwise) {
  std::vector<float> along(points.count), across(points.count);
  burin_stroke_context context = stroke_context();
  context.length = length;
  require(filter.filter(&brush.abi(), stroke.self(), &context, &stroke.params(), &points,
                        {along.data(), 1, 0}, {across.data(), 1, 0}, nullptr) == BURIN_OK,
          otherwise);
  along.insert(along.end(), across.begin(), across.end());
  return along;
}

}  // namespace burin::validate
