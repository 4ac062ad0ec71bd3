// Stores a box of voxels, with trilinear interpolation between them. Voxels are stored in blocks of 8 x 8 x
// 8, of which those of one value are stored as that value.
#include <burin/volume/voxel_field.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {
namespace {

/// Where between the middles of two voxels a coordinate lies.
struct Between {
  int lower = 0, upper = 0;
  float share = 0;    ///< of the upper one
  double beyond = 0;  ///< voxels beyond the outermost middle
};

Between between(double x, int size, bool periodic) {
  const double from_middle = x - 0.5;
  if (periodic) {
    const double turned = from_middle - std::floor(from_middle / size) * size;
    const int lower = std::min(static_cast<int>(turned), size - 1);
    return {lower, lower + 1 < size ? lower + 1 : 0, static_cast<float>(turned - lower), 0};
  }
  const double inside = std::clamp(from_middle, 0.0, static_cast<double>(size - 1));
  const int lower = std::min(static_cast<int>(inside), std::max(size - 2, 0));
  return {lower, std::min(lower + 1, size - 1), static_cast<float>(inside - lower),
          std::abs(from_middle - inside)};
}

}  // namespace

VoxelField::VoxelField(Kind kind, const Eigen::Vector3i& size, double unit, const FillBlock& fill)
    : kind_(kind),
      size_(size),
      blocks_along_((size.array() + side - 1) / side),
      per_unit_(kind == Kind::level_set ? static_cast<float>(1 / unit) : 1),
      minimum_(std::numeric_limits<float>::max()),
      maximum_(std::numeric_limits<float>::lowest()) {
  std::array<float, 512> values{};
  for (int x = 0; x < size.x(); x += side)
    for (int y = 0; y < size.y(); y += side)
      for (int z = 0; z < size.z(); z += side) {
        const Eigen::Vector3i first(x, y, z);
        fill(first, values);
        add_block(values, (size - first).cwiseMin(side));
      }
  minimum_ *= per_unit_;
  maximum_ *= per_unit_;
}

/// `extent`: of the block's part within the box.
void VoxelField::add_block(const std::array<float, 512>& values, const Eigen::Vector3i& extent) {
  bool uniform = true;
  for (int i = 0; i < extent.x(); ++i)
    for (int j = 0; j < extent.y(); ++j)
      for (int k = 0; k < extent.z(); ++k) {
        const int number = 64 * i + 8 * j + k;
        const float value = values[static_cast<std::size_t>(number)];
        minimum_ = std::min(minimum_, value);
        maximum_ = std::max(maximum_, value);
        uniform = uniform && value == values[0];
      }
  blocks_.push_back({static_cast<std::uint32_t>(values_.size()), uniform});
  values_.insert(values_.end(), values.begin(), uniform ? values.begin() + 1 : values.end());
}

float VoxelField::voxel(int i, int j, int k) const {
  const int number = ((i / side) * blocks_along_.y() + j / side) * blocks_along_.z() + k / side;
  const int within = 64 * (i % side) + 8 * (j % side) + k % side;
  const Block& block = blocks_[static_cast<std::size_t>(number)];
  if (block.uniform) return values_[block.first];
  return values_[block.first + static_cast<std::size_t>(within)];
}

float VoxelField::at(const Vec3d& place, const std::array<bool, 3>& periodic) const {
  // Farther away voxels would have no numbers.
  constexpr double farthest = 1e15;
  if (!(place.cwiseAbs().maxCoeff() <= farthest)) return std::numeric_limits<float>::quiet_NaN();
  const Between x = between(place.x(), size_.x(), periodic[0]),
                y = between(place.y(), size_.y(), periodic[1]),
                z = between(place.z(), size_.z(), periodic[2]);
  const auto mix = [](float a, float b, float share) { return a + share * (b - a); };
  const auto along_z = [&](int i, int j) { return mix(voxel(i, j, z.lower), voxel(i, j, z.upper), z.share); };
  const auto along_y = [&](int i) { return mix(along_z(i, y.lower), along_z(i, y.upper), y.share); };
  const float value = per_unit_ * mix(along_y(x.lower), along_y(x.upper), x.share);
  const double squared = x.beyond * x.beyond + y.beyond * y.beyond + z.beyond * z.beyond;
  if (squared == 0) return value;
  if (kind_ == Kind::fog) return 0;
  // The way from the nearest place of a box to any place in it makes no acute angle with the way to the box.
  const double there = std::max(static_cast<double>(value), 0.0);
  return static_cast<float>(std::sqrt(squared + there * there));
}

}  // namespace burin
