// org.burin.rivets: makes a row of rivet heads, parts of spheres.

#include <burin/plugin/plugin.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

using namespace burin::plugin;

class Rivets : public SolidBrush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.rivets",
      .name = "Rivets",
      .vendor = "Burin",
      .version = "1.0.0",
      .help = "Sets a row of rivet heads along the stroke.",
      .features = {"procedural", "solid"},
      .inputs = BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS,
      .outputs = 0,
  };
  static constexpr FloatParam width = common::whole_width("Half the width of a head.", 0.5f);
  static constexpr FloatParam height{
      .id = "height",
      .name = "Height",
      .help = "Of a head over the surface, in its half widths: 1 is half a sphere.",
      .hard = {0.1f, 1.9f},
      .default_value = 0.7f,
  };
  static constexpr FloatParam spacing{
      .id = "spacing",
      .name = "Spacing",
      .help = "From head to head, in widths of a head.",
      .hard = {1, 1000},
      .soft = {1, 6},
      .default_value = 2,
  };
  static constexpr auto params = param_list(width, height, spacing);

  explicit Rivets(StrokeStart& start)
      : half_(start.params[width].value() * static_cast<float>(start.stroke.radius_max())),
        height_(start.params[height].value() * half_),
        sphere_((half_ * half_ + height_ * height_) / (2 * height_)),
        spacing_(2 * double{half_} * start.params[spacing].value()) {}

  /// A head goes on below the surface by a quarter of its height.
  SolidPlan solid(const Stroke&, const Params&) const override {
    return {.h_min = -height_ / 4, .h_max = height_, .detail = std::min(half_, height_)};
  }

  void distance(const Batch& in, Floats h, FloatsOut out) const override {
    const Floats t = in.t(), d = in.d();
    const double period = in.stroke.whole_period(spacing_);
    for (std::size_t i = 0; i < in.size(); ++i) {
      const float along = in.stroke.from_mark(t[i], period);
      const float ball = circle({math::hypot(along, d[i]), h[i] - (height_ - sphere_)}, sphere_);
      out[i] = cut(cut(ball, math::hypot(along, d[i]) - half_), -h[i] - height_ / 4);
    }
  }

 private:
  const float half_, height_;  // object units
  const float sphere_;         // radius of the sphere that a head is part of
  const double spacing_;
};

}  // namespace

BURIN_PLUGIN(Rivets);
