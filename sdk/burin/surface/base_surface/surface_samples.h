#pragma once
#include <burin/base/vector.h>

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

namespace burin {

/// A point of a surface with a vector along its normal: an area vector, object units^2, or a unit vector.
struct SurfaceSample {
  Vec3f position, up;
  float spread = 0;  ///< ClusterMean::spread if the position is a cluster's mean
};

/// Samples in blocks of lanes for vector instructions; the last block is padded with samples of zero area.
class SurfaceSamples {
 public:
  static constexpr int lanes = 8;
  using Lanes = Eigen::Array<float, lanes, 1>;
  struct Vectors {
    Lanes x, y, z;
    Lanes dot(const Vec3f& with) const { return x * with.x() + y * with.y() + z * with.z(); }
    Lanes squared_length() const { return x * x + y * y + z * z; }
  };
  struct Block {
    Vectors position, up;
    Lanes spread;
    Vectors from(const Vec3f& origin) const {
      return {position.x - origin.x(), position.y - origin.y(), position.z - origin.z()};
    }
  };

  explicit SurfaceSamples(std::span<const SurfaceSample> samples) {
    blocks_.resize((samples.size() + lanes - 1) / lanes);
    for (std::size_t i = 0; i < blocks_.size() * lanes; ++i) {
      const bool filled_up = i >= samples.size();
      const SurfaceSample& sample = samples[filled_up ? 0 : i];
      Block& block = blocks_[i / lanes];
      const auto lane = static_cast<Eigen::Index>(i % lanes);
      set(block.position, lane, sample.position);
      set(block.up, lane, filled_up ? Vec3f::Zero() : sample.up);
      block.spread[lane] = sample.spread;
    }
  }

  std::span<const Block> blocks() const { return blocks_; }

 private:
  static void set(Vectors& vectors, Eigen::Index lane, const Vec3f& value) {
    vectors.x[lane] = value.x();
    vectors.y[lane] = value.y();
    vectors.z[lane] = value.z();
  }

  std::vector<Block> blocks_;
};

}  // namespace burin
