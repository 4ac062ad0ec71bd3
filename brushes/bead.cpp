// org.burin.bead: raises a half-round moulding or a string of round beads. The surface is spread evenly over
// the half circle of the cross-section, so points move up and outwards.

#include <burin/plugin/plugin.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

using namespace burin::plugin;

class Bead : public Brush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.bead",
      .name = "Bead",
      .vendor = "Burin",
      .version = "1.0.0",
      .help = "Raises a half-round rod or a string of beads.",
      .features = {"procedural"},
      .inputs = BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS,
      .outputs = BURIN_OUTPUT_DISPLACEMENT,
  };
  static constexpr FloatParam height =
      common::roundness("Height over half width: 1 is a half circle, below 0 a channel.", 1);
  static constexpr FloatParam width =
      common::constant(common::width("Distance from the middle to the rim.", 0.8f));
  enum Form { rod, beads };
  static constexpr ChoiceParam form{
      .id = "form",
      .name = "Form",
      .help = "One rod along the stroke, or beads along it.",
      .choices = {"rod", "beads"},
      .default_value = rod,
  };
  static constexpr FloatParam spacing{
      .id = "spacing",
      .name = "Spacing",
      .help = "From bead to bead, in bead widths: at 1 they touch.",
      .hard = {1, 1000},
      .soft = {1, 4},
      .default_value = 1,
  };
  static constexpr auto params = param_list(height, width, form, spacing);

  explicit Bead(StrokeStart& start)
      : width_(start.params[width].value()),
        form_(start.params[form].value()),
        period_(2 * width_ * start.params[spacing].value() * start.stroke.radius_max()) {
    if (form_ == beads) start.end_influence = period_;
  }

  void evaluate(const Batch& in, const Outputs& out) const override {
    const Floats t = in.t(), d = in.d(), radius = in.radius(), heights = in.params[height];
    const FloatsOut along = out.along(), across = out.across(), up = out.up();
    const double period = in.stroke.whole_period(period_);
    for (std::size_t i = 0; i < in.size(); ++i) {
      const float half_width = std::min(width_ * radius[i], static_cast<float>(period / 2));
      const float from_middle = form_ == rod ? in.stroke.beyond(t[i]) : in.stroke.from_mark(t[i], period);
      const float x = math::hypot(from_middle, d[i]) / half_width;
      if (x >= 1) continue;
      const float angle = 0.5f * std::numbers::pi_v<float> * x;  // from the top of the half circle
      const float spread = x > 1e-3f ? math::sin(angle) / x - 1 : 0.5f * std::numbers::pi_v<float> - 1;
      along[i] = spread * from_middle;
      across[i] = spread * d[i];
      up[i] = heights[i] * half_width * math::cos(angle);
    }
  }

 private:
  const float width_;  // radii
  const int form_;
  const double period_;  // distance of beads on an open stroke, object units
};

}  // namespace

BURIN_PLUGIN(Bead);
