#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <limits>

namespace burin {

using Vec2f = Eigen::Vector2f;
using Vec3f = Eigen::Vector3f;
using Vec3d = Eigen::Vector3d;

/// Vectors and matrices that are aligned like their elements. Eigen's own types of 16 bytes or multiples are
/// aligned according to compiler flags (-mavx2), so that structs of them would have another layout in the
/// library than in a program that uses it. Matrices are stored by columns.
using Vec4f = Eigen::Matrix<float, 4, 1, Eigen::DontAlign>;
using Vec2d = Eigen::Matrix<double, 2, 1, Eigen::DontAlign>;
using Mat3f = Eigen::Matrix<float, 3, 3, Eigen::DontAlign>;
using Mat3d = Eigen::Matrix<double, 3, 3, Eigen::DontAlign>;
using Mat4d = Eigen::Matrix<double, 4, 4, Eigen::DontAlign>;

/// Index of a vertex, triangle or node. `no_index` means "none".
using Index = std::uint32_t;
inline constexpr Index no_index = std::numeric_limits<Index>::max();

/// Three vertices, counter-clockwise seen from outside.
using Triangle = std::array<Index, 3>;

}  // namespace burin
