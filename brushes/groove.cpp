// org.burin.groove: pushes a profile into the surface along the stroke and fades it out towards the ends.

#include <burin/plugin/plugin.h>

#include <algorithm>

namespace {

using namespace burin::plugin;

class Groove : public Brush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.groove",
      .name = "Groove",
      .vendor = "Burin",
      .version = "1.0.0",
      .help = "Engraves a procedural profile along the stroke.",
      .features = {"procedural"},
      .inputs = BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS | BURIN_INPUT_END_DISTANCE,
      .outputs = BURIN_OUTPUT_DISPLACEMENT,
      .rim_slope = 22.5f,  // of a flat profile, 9/8 times 2, with the greatest depth
      .budget = 100,
  };
  static constexpr FloatParam depth =
      common::depth("Depth along the middle; below 0 a ridge.", {0, 1}, 0.25f);
  static constexpr FloatParam width = common::width("Distance from the middle to the rim.", 1);
  static constexpr FloatParam taper =
      common::taper("Length over which the groove rises to the surface at either end.", 2);
  enum Profile { round, v, flat };
  static constexpr ChoiceParam profile{
      .id = "profile",
      .name = "Profile",
      .help = "Shape across the groove.",
      .choices = {"round", "v", "flat"},
      .default_value = round,
  };
  static constexpr auto params = param_list(depth, width, taper, profile);

  explicit Groove(StrokeStart& start)
      : taper_(start.params[taper].value()), profile_(start.params[profile].value()) {
    start.end_influence = taper_influence(start.stroke, taper_);
  }

  void evaluate(const Batch& in, const Outputs& out) const override {
    const Floats t = in.t(), d = in.d(), radius = in.radius(), end_distance = in.end_distance();
    const Floats depths = in.params[depth], widths = in.params[width];
    const FloatsOut up = out.up();
    for (std::size_t i = 0; i < in.size(); ++i) {
      const float across = in.stroke.distance(t[i], d[i]) / (widths[i] * radius[i]);
      up[i] = -depths[i] * radius[i] * shape(across) *
              taper_factor(in.stroke, end_distance[i], radius[i], taper_);
    }
  }

 private:
  /// The profile: 1 in the middle (x = 0), falling to 0 with zero slope at the rim (x = 1).
  float shape(float x) const {
    const float inside = std::max(1 - x, 0.0f);
    switch (profile_) {
      case v:
        return inside * inside;
      case flat:
        return smooth_step(2 * inside);
      default:
        return inside * inside * (1 + x) * (1 + x);
    }
  }

  const float taper_;  // radii
  const int profile_;
};

}  // namespace

BURIN_PLUGIN(Groove);
