// org.burin.tube: makes a rod or a pipe along the stroke, of round, square or star section.

#include <burin/plugin/plugin.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

using namespace burin::plugin;

class Tube : public SolidBrush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.tube",
      .name = "Tube",
      .vendor = "Burin",
      .version = "1.0.0",
      .help = "Lays a rod or a pipe of round, square or star section along the stroke.",
      .features = {"procedural", "solid"},
      .inputs = BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS,
      .outputs = 0,
  };
  static constexpr FloatParam width = common::width("Half the width of the section.", 0.4f);
  enum Profile { round, square, star };
  static constexpr ChoiceParam profile{
      .id = "profile",
      .name = "Profile",
      .help = "Shape of the section; a star has five points.",
      .choices = {"round", "square", "star"},
      .default_value = round,
  };
  static constexpr FloatParam wall{
      .id = "wall",
      .name = "Wall",
      .help = "Thickness of the wall, a share of the half width; 1 is solid.",
      .hard = {0.05f, 1},
      .default_value = 1,
  };
  static constexpr FloatParam height{
      .id = "height",
      .name = "Height",
      .help = "Of the middle over the surface, in half widths: 0 is half sunk, 1 lies on it.",
      .hard = {-10, 10},
      .soft = {-1, 2},
      .default_value = 1,
  };
  enum Ends { flat_ends, round_ends };
  static constexpr ChoiceParam ends{
      .id = "ends",
      .name = "Ends",
      .help = "How an open stroke ends: cut off, or a round cap.",
      .choices = {"flat", "round"},
      .default_value = round_ends,
  };
  static constexpr auto params = param_list(width, profile, wall, height, ends);

  explicit Tube(StrokeStart& start)
      : width_(start.params[width].value()),
        profile_(start.params[profile].value()),
        wall_(start.params[wall].value()),
        height_(start.params[height].value()),
        ends_(start.params[ends].value()) {}

  SolidPlan solid(const Stroke& stroke, const Params&) const override {
    const double most = width_ * stroke.radius_max(), least = width_ * stroke.radius_min();
    return {.h_min = std::min(height_ * least, height_ * most) - most,
            .h_max = std::max(height_ * least, height_ * most) + most,
            .detail = std::max(least, most / 20) * std::min(2.0F, 2 * wall_) * (profile_ == star ? 0.4 : 1)};
  }

  void distance(const Batch& in, Floats h, FloatsOut out) const override {
    const Floats t = in.t(), d = in.d(), radius = in.radius(), widths = in.params[width];
    for (std::size_t i = 0; i < in.size(); ++i) {
      const float half = widths[i] * radius[i];
      out[i] = pipe({d[i], h[i] - height_ * half}, in.stroke.past_ends(t[i]), half);
    }
  }

 private:
  /// At this place of the section's plane, so far past an end.
  float pipe(Point p, float past, float half) const {
    const float reach = ends_ == round_ends ? std::max(past, 0.0F) : 0;
    const float inner = half * (1 - wall_);
    const float outside = capped(p, reach, half);
    const float solid = wall_ < 1 ? cut(outside, -section(p, inner)) : outside;
    return ends_ == flat_ends ? cut(solid, past) : solid;
  }

  /// Beyond an end the section shrinks as a round cap does.
  float capped(Point p, float reach, float half) const {
    if (profile_ == round) return math::hypot(math::hypot(p.x, p.y), reach) - half;
    return reach > 0 ? section(p, half) + half - std::sqrt(std::max(half * half - reach * reach, 0.0F))
                     : section(p, half);
  }

  float section(Point p, float half) const {
    if (profile_ == round) return circle(p, half);
    if (profile_ == square) return box(p, half, half);
    return star_section(p, (1 - rounded) * half) - rounded * half;
  }

  /// A star of five points, each a wedge between two of its sides; a lower bound outside.
  static float star_section(Point p, float half) {
    constexpr float fifth = 2 * std::numbers::pi_v<float> / 5, inner_share = 0.5F;
    const float from_point = math::atan2(p.x, p.y) / fifth;
    const float angle = std::abs(from_point - std::round(from_point)) * fifth, far = math::hypot(p.x, p.y);
    const Point q{far * math::cos(angle), far * math::sin(angle)};
    // From the point (half, 0) to the notch at half the angle.
    const Point notch{inner_share * half * math::cos(fifth / 2), inner_share * half * math::sin(fifth / 2)};
    const Point side{notch.x - half, notch.y};
    return ((q.x - half) * side.y - q.y * side.x) / math::hypot(side.x, side.y);
  }

  static constexpr float rounded = 0.12F;  // radius of a star's points, half widths

  const float width_;  // radii
  const int profile_;
  const float wall_, height_;
  const int ends_;
};

}  // namespace

BURIN_PLUGIN(Tube);
