// org.burin.rope: lays strands that wind around each other or are plaited.

#include <burin/plugin/plugin.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

using namespace burin::plugin;

class Rope : public Brush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.rope",
      .name = "Rope",
      .vendor = "Burin",
      .version = "1.0.0",
      .help = "Lays a twisted rope or a plait of strands that run over and under each other.",
      .features = {"procedural"},
      .inputs = BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS,
      .outputs = BURIN_OUTPUT_DISPLACEMENT,
  };
  static constexpr FloatParam height = common::roundness("Height over half width: 1 is round.", 1);
  static constexpr FloatParam width = common::width("Distance from the middle to the rim.", 0.8f);
  enum Lay { twisted, plaited };
  static constexpr ChoiceParam lay{
      .id = "lay",
      .name = "Lay",
      .help = "How the strands run; two strands plaited are two strands twisted.",
      .choices = {"twisted", "plaited"},
      .default_value = twisted,
  };
  static constexpr IntParam strands{
      .id = "strands",
      .name = "Strands",
      .help = "Number of strands.",
      .hard = {2, 3},
      .default_value = 3,
  };
  static constexpr FloatParam turn{
      .id = "turn",
      .name = "Turn",
      .help = "Length along the stroke after which a strand is back on its side.",
      .unit = BURIN_UNIT_RADIUS,
      .hard = {0.1f, 1000},
      .soft = {1, 10},
      .default_value = 4,
  };
  static constexpr auto params = param_list(height, width, lay, strands, turn);

  explicit Rope(StrokeStart& start)
      : strands_(start.params[strands].value()),
        plaited_(start.params[lay].value() == plaited && strands_ == 3),
        turn_(start.params[turn].value() * start.stroke.radius_max()) {}

  void evaluate(const Batch& in, const Outputs& out) const override {
    const Floats t = in.t(), d = in.d(), radius = in.radius();
    const Floats heights = in.params[height], widths = in.params[width];
    const FloatsOut up = out.up();
    const double turn_length = in.stroke.whole_period(turn_);
    for (std::size_t i = 0; i < in.size(); ++i) {
      const float beyond = in.stroke.beyond(t[i]) / radius[i];
      const float half_width = widths[i] * radius[i] * (1 - beyond * beyond);  // falls to 0 within the caps
      if (std::abs(d[i]) >= half_width) continue;
      const auto turns = static_cast<float>(t[i] / turn_length - std::floor(t[i] / turn_length));
      const float steepness = half_width / static_cast<float>(turn_length);
      up[i] = heights[i] * half_width * surface(turns, d[i] / half_width, steepness);
    }
  }

 private:
  /// The height at y across a rope of half width 1: that of the highest strand, limited so that it is 0 at
  /// the rim.
  float surface(float turns, float y, float steepness) const {
    const float share = 1 / static_cast<float>(strands_);
    // Strands touch each other, and the straight sides of their profiles reach the rim.
    const float sine = strands_ == 2 ? 1 : 0.8660254f;
    const float orbit = 1 / (1 + sine / 0.9f), thickness = sine * orbit;
    float highest = 0;
    for (int strand = 0; strand < strands_; ++strand) {
      const float angle = 2 * std::numbers::pi_v<float> * (turns + share * static_cast<float>(strand));
      const float lift = orbit * (plaited_ ? 0.5f * math::sin(2 * angle) : math::cos(angle));
      const float slope = 2 * std::numbers::pi_v<float> * orbit * steepness * math::cos(angle);
      const float distance = std::abs(y - orbit * math::sin(angle)) / std::sqrt(1 + slope * slope);
      highest = std::max(highest, lift + thickness * strand_profile(distance / thickness));
    }
    return std::min(highest, 3 * (1 - std::abs(y)));
  }

  const int strands_;
  const bool plaited_;
  const double turn_;  // length of a turn on an open stroke, object units
};

}  // namespace

BURIN_PLUGIN(Rope);
