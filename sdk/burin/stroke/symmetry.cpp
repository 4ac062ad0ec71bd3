// Lists the elements of the symmetry group of mirror planes and rotations as matrices.
#include <burin/base/error.h>
#include <burin/math/elementary.h>
#include <burin/stroke/symmetry.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burin {
namespace {

constexpr std::size_t most_instances = 1024;

Eigen::Matrix3d rotation(const Symmetry& symmetry, int step) {
  if (step == 0) return Eigen::Matrix3d::Identity();
  const double angle = 2 * std::numbers::pi * step / symmetry.radial;
  const int from = (symmetry.axis + 1) % 3, to = (symmetry.axis + 2) % 3;
  Eigen::Matrix3d turned = Eigen::Matrix3d::Identity();
  turned(from, from) = turned(to, to) = math::cos(angle);
  turned(to, from) = math::sin(angle);
  turned(from, to) = -turned(to, from);
  return turned;
}

/// The product of the mirrorings at those axes whose bits are set in `chosen`.
Eigen::Matrix3d mirroring(const std::vector<int>& axes, std::size_t chosen) {
  Vec3d signs = Vec3d::Ones();
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (chosen >> i & 1) signs[axes[i]] = -1;
  return signs.asDiagonal();
}

/// Whether an image is in the list already. Two mirrorings may equal a half turn, which may also be a radial
/// copy.
bool has_image(const std::vector<SymmetryInstance>& instances, const Eigen::Matrix3d& linear) {
  return std::ranges::any_of(instances, [&](const SymmetryInstance& instance) {
    return (instance.linear - linear).cwiseAbs().maxCoeff() < 1e-9;
  });
}

}  // namespace

std::vector<SymmetryInstance> symmetry_instances(const Symmetry& symmetry) {
  if (symmetry.radial < 1)
    throw ContractError(fmt::format("radial symmetry needs at least one copy, not {}", symmetry.radial));
  if (symmetry.axis < 0 || symmetry.axis > 2 || !symmetry.centre.allFinite())
    throw ContractError("a symmetry without a proper axis or centre");
  std::vector<int> axes;
  if (symmetry.mirror_x) axes.push_back(0);
  if (symmetry.mirror_y) axes.push_back(1);
  if (symmetry.mirror_z) axes.push_back(2);
  const std::size_t mirrorings = std::size_t{1} << axes.size();
  if (static_cast<std::size_t>(symmetry.radial) * mirrorings > most_instances)
    throw ContractError(fmt::format("more than {} symmetric images of a stroke", most_instances));
  std::vector<SymmetryInstance> instances;
  for (int step = 0; step < symmetry.radial; ++step) {
    for (std::size_t chosen = 0; chosen < mirrorings; ++chosen) {
      const Eigen::Matrix3d linear = rotation(symmetry, step) * mirroring(axes, chosen);
      if (has_image(instances, linear)) continue;
      const auto index = static_cast<std::uint32_t>(instances.size());
      instances.push_back({linear, symmetry.centre, index, linear.determinant() < 0});
    }
  }
  return instances;
}

}  // namespace burin
