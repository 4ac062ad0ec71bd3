#pragma once
#include <burin/base/vector.h>
#include <burin/stamp/files/picture.h>
#include <burin/stroke/camera.h>
#include <burin/surface/picker.h>

#include <array>
#include <cstdint>
#include <vector>

namespace burin {

/// sRGB, 0..255.
using Ink = std::array<std::uint8_t, 3>;

/// Lines over a picture, as dots half a pixel apart. Drawing twice does not darken. Coordinates are pixels
/// from the top left corner.
class LineLayer {
 public:
  LineLayer(int width, int height);
  void add_dot(double x, double y, const Ink& ink);
  void add_line(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Ink& ink);

  /// Blends the lines over a picture of this size.
  void blend(Picture& picture) const;

 private:
  int width_, height_;
  std::vector<float> share_;  ///< of each pixel, that the lines cover
  std::vector<Ink> ink_;
};

/// Draws lines in space, except where a surface hides them.
class Pencil {
 public:
  /// Parts at most `depth` (object units) below the surface are visible too. Refers to all that it is given.
  Pencil(LineLayer& layer, const Camera& camera, const Picker& picker, double depth)
      : layer_(layer), camera_(camera), picker_(picker), depth_(depth) {}

  void draw(const Vec3d& a, const Vec3d& b, const Ink& ink);

 private:
  bool sees(const Eigen::Vector2d& pixel, const Vec3d& position) const;

  LineLayer& layer_;
  const Camera& camera_;
  const Picker& picker_;
  double depth_;
};

}  // namespace burin
