#pragma once
#include <Eigen/Core>
#include <functional>
#include <string_view>

namespace burin {

/// Chords that stand for a curve of an SVG path.
inline constexpr int chords_of_svg_curve = 8;

/// Follows the data of an SVG path: calls `begin` where a subpath begins, then `point` with each of its
/// points. Lines give their ends; Bézier curves and arcs chords_of_svg_curve points each. Throws Error for
/// what is no path data; the points before have been told then.
void follow_svg_path(std::string_view data, const std::function<void()>& begin,
                     const std::function<void(const Eigen::Vector2d& point)>& point);

}  // namespace burin
