// org.burin.crease: cuts a sharp valley or folds up a sharp ridge, with raised sides.

#include <burin/plugin/plugin.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace burin::plugin;

class Crease : public Brush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.crease",
      .name = "Crease",
      .vendor = "Burin",
      .version = "1.0.0",
      .help = "Cuts a sharp valley, or folds up a sharp ridge, and gathers the surface along it.",
      .features = {"procedural"},
      .inputs = BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS | BURIN_INPUT_END_DISTANCE,
      .outputs = BURIN_OUTPUT_DISPLACEMENT,
      .rim_slope = 23.71f,  // of the sides, 16 times 4/27, with the greatest depth, and 1/4 of the pull
  };
  static constexpr FloatParam depth =
      common::depth("Depth along the middle; below 0 a ridge.", {-1, 1}, 0.35f);
  static constexpr FloatParam sharpness{
      .id = "sharpness",
      .name = "Sharpness",
      .help = "How steeply the sides fall to the middle: exponent of the profile.",
      .hard = {1.5f, 32},
      .soft = {2, 10},
      .default_value = 5,
      .dynamic = true,
  };
  static constexpr FloatParam bulge{
      .id = "bulge",
      .name = "Bulge",
      .help = "Height of the sides as a share of the depth.",
      .hard = {0, 1},
      .default_value = 0.25f,
      .dynamic = true,
  };
  static constexpr FloatParam pinch{
      .id = "pinch",
      .name = "Pinch",
      .help = "How much the surface is drawn together towards the middle.",
      .hard = {0, 1},
      .default_value = 0.3f,
      .dynamic = true,
  };
  static constexpr FloatParam taper =
      common::taper("Length over which the crease fades out at either end.", 3);
  static constexpr auto params = param_list(depth, sharpness, bulge, pinch, taper);

  explicit Crease(StrokeStart& start) : taper_(start.params[taper].value()) {
    start.end_influence = taper_influence(start.stroke, taper_);
  }

  void evaluate(const Batch& in, const Outputs& out) const override {
    const Floats t = in.t(), d = in.d(), radius = in.radius(), end_distance = in.end_distance();
    const Floats depths = in.params[depth], exponents = in.params[sharpness];
    const Floats bulges = in.params[bulge], pinches = in.params[pinch];
    const FloatsOut along = out.along(), across = out.across(), up = out.up();
    for (std::size_t i = 0; i < in.size(); ++i) {
      const float x = in.stroke.distance(t[i], d[i]) / radius[i], inside = std::max(1 - x, 0.0f);
      const float valley = math::pow(inside, exponents[i]);
      const float side =
          16 * x * x * inside * inside;  // 1 half way to the rim, 0 with zero slope at both ends
      const float ends = taper_factor(in.stroke, end_distance[i], radius[i], taper_);
      const float pull = pinches[i] * inside * inside * ends;  // never beyond the middle
      along[i] = -pull * in.stroke.beyond(t[i]);
      across[i] = -pull * d[i];
      up[i] = depths[i] * radius[i] * (bulges[i] * side - valley) * ends;
    }
  }

 private:
  const float taper_;  // radii
};

}  // namespace

BURIN_PLUGIN(Crease);
