// Draws what snapping did. The images over (t, d) are scaled without smoothing.
#include "snap/snap_picture.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "pictures/curve_overlay.h"
#include "pictures/pencil.h"
#include "pictures/render.h"
#include "system/console.h"

namespace burin::command {
namespace {

constexpr Ink red_ink = {214, 30, 30};

/// The brightness of levels: from the 2nd to the 98th percentile of them.
class Brightness {
 public:
  explicit Brightness(const LevelImage& level) {
    std::vector<float> values;
    for (const float value : level.values)
      if (!std::isnan(value)) values.push_back(value);
    if (values.empty()) return;
    std::ranges::sort(values);
    const auto at = [&](double share) {
      return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
    };
    least_ = at(0.02);
    most_ = at(0.98);
  }

  std::uint8_t of(float level) const {
    constexpr std::uint8_t unknown = 90;
    if (std::isnan(level)) return unknown;
    const float share = most_ > least_ ? (level - least_) / (most_ - least_) : 0.5F;
    return static_cast<std::uint8_t>(std::lround(60 + 190 * std::clamp(share, 0.F, 1.F)));
  }

 private:
  float least_ = 0, most_ = 0;
};

/// Where an image is drawn in a picture, pixels of the picture.
struct Inset {
  int left = 0, top = 0;
  double scale = 1;  ///< pixels of the picture per pixel of the image
  int width = 0, height = 0;
};

Inset inset_of(const SnapImage& image, const Picture& picture, int top) {
  constexpr double share_of_width = 0.45, share_of_height = 0.22;
  constexpr int border = 8;
  const double columns = static_cast<double>(image.rows.size()), rows = image.level.grid.rows;
  Inset inset{.left = border, .top = top + border};
  inset.scale = std::min(share_of_width * picture.width / columns, share_of_height * picture.height / rows);
  inset.width = std::max(1, static_cast<int>(columns * inset.scale));
  inset.height = std::max(1, static_cast<int>(rows * inset.scale));
  return inset;
}

/// Draws an image and its path; returns the row of the picture below it.
int draw_image(Picture& picture, const SnapImage& image, int top) {
  const Inset inset = inset_of(image, picture, top);
  const Brightness brightness(image.level);
  const int rows = image.level.grid.rows;
  for (int y = 0; y < inset.height; ++y) {
    for (int x = 0; x < inset.width; ++x) {
      const int column = image.first + static_cast<int>(x / inset.scale);
      const int row = std::clamp(rows - 1 - static_cast<int>(y / inset.scale), 0, rows - 1);
      const std::uint8_t byte = brightness.of(image.level.at(column, row));
      const auto pixel = static_cast<std::size_t>(inset.top + y) * static_cast<std::size_t>(picture.width) +
                         static_cast<std::size_t>(inset.left + x);
      std::fill_n(picture.rgb.begin() + static_cast<std::ptrdiff_t>(3 * pixel), 3, byte);
    }
  }
  const auto place = [&](double column, double row) {
    return Eigen::Vector2d(inset.left + (column + 0.5) * inset.scale,
                           inset.top + (rows - 0.5 - row) * inset.scale);
  };
  LineLayer lines(picture.width, picture.height);
  const auto last = static_cast<double>(image.rows.size() - 1);
  const double stroke_row = image.level.grid.stroke_row();
  lines.add_line(place(0, stroke_row), place(last, stroke_row), dark_ink);
  for (std::size_t i = 1; i < image.rows.size(); ++i)
    lines.add_line(place(static_cast<double>(i - 1), image.rows[i - 1]),
                   place(static_cast<double>(i), image.rows[i]), red_ink);
  lines.blend(picture);
  return inset.top + inset.height;
}

}  // namespace

Picture snap_picture(const Surface& surface, const Picker& picker, const Camera& camera,
                     std::span<const SnappedStroke> strokes, double depth) {
  ProgressBar bar;
  Picture picture = render(surface, picker, camera, clay, bar.progress());
  for (const SnappedStroke& snapped : strokes) {
    draw_curve(picture, camera, picker, snapped.stroke, depth);
    for (const SurfaceCurve& curve : snapped.moved)
      draw_curve(picture, camera, picker, curve, depth, red_ink);
  }
  const std::vector<SnapImage>& images = strokes[0].images;
  if (images.empty()) return picture;
  const int below = draw_image(picture, images.front(), 0);
  if (images.size() > 1) draw_image(picture, images.back(), below);
  return picture;
}

}  // namespace burin::command
