// org.burin.pinch: draws the surface together towards the stroke.

#include <burin/plugin/plugin.h>

#include <algorithm>

namespace {

using namespace burin::plugin;

class Pinch : public Brush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.pinch",
      .name = "Pinch",
      .vendor = "Burin",
      .version = "1.0.0",
      .help = "Draws the surface together towards the stroke, so that what is there becomes narrower.",
      .features = {"procedural"},
      .inputs = BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS | BURIN_INPUT_STRETCH,
      .outputs = BURIN_OUTPUT_DISPLACEMENT,
      .rim_slope = 11.26f,  // of the greatest lift, times 9/8, and 1/4 of the pull
  };
  static constexpr FloatParam amount = common::amount(
      "1 draws the surface next to the stroke onto it; below 0 pushes it away.", {-1, 1}, 0.75f);
  static constexpr FloatParam lift{
      .id = "lift",
      .name = "Lift",
      .help = "Height that the surface along the stroke gains; below 0 it sinks.",
      .unit = BURIN_UNIT_RADIUS,
      .hard = {-10, 10},
      .soft = {-1, 1},
      .default_value = 0,
      .dynamic = true,
  };
  static constexpr auto params = param_list(amount, lift);

  void evaluate(const Batch& in, const Outputs& out) const override {
    const Floats t = in.t(), d = in.d(), radius = in.radius(), stretch = in.stretch();
    const Floats amounts = in.params[amount], lifts = in.params[lift];
    const FloatsOut along = out.along(), across = out.across(), up = out.up();
    for (std::size_t i = 0; i < in.size(); ++i) {
      const float inside = std::max(1 - in.stroke.distance(t[i], d[i]) / radius[i], 0.0f);
      // The slope of x (1 - x)^2 is at most 1, so points keep their order and their side of the stroke.
      // Inside of a bend of radius b the stretch is 1 - x / b, so the pull falls to 0 at the centre of the
      // bend, across which the nearest point of the stroke changes to the opposite side.
      const float pull = amounts[i] * inside * inside * std::min(stretch[i], 1.0f);
      along[i] = -pull * in.stroke.beyond(t[i]);
      across[i] = -pull * d[i];
      up[i] = lifts[i] * radius[i] * smooth_step(inside);
    }
  }
};

}  // namespace

BURIN_PLUGIN(Pinch);
