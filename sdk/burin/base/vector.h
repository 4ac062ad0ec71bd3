#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <limits>

namespace burin {

using Vec2f = Eigen::Vector2f;
using Vec3f = Eigen::Vector3f;
using Vec4f = Eigen::Vector4f;
using Vec2d = Eigen::Vector2d;
using Vec3d = Eigen::Vector3d;

/// Index of a vertex, triangle or node. `no_index` stands for "none".
using Index = std::uint32_t;
inline constexpr Index no_index = std::numeric_limits<Index>::max();

/// Three vertices, counter-clockwise seen from outside.
using Triangle = std::array<Index, 3>;

}  // namespace burin
