#include <burin/plugin/plugin.h>

using namespace burin::plugin;

class Ripple : public Brush {
 public:
  static constexpr BrushInfo info{
      .id = "org.example.ripple", .name = "Ripple", .vendor = "Example", .version = "1.0.0"};
  static constexpr FloatParam height{.id = "height",
                                     .name = "Height",
                                     .unit = BURIN_UNIT_RADIUS,
                                     .hard = {0, 1},
                                     .default_value = 0.1f,
                                     .dynamic = true};
  static constexpr FloatParam wave{
      .id = "wave", .name = "Wavelength", .unit = BURIN_UNIT_RADIUS, .hard = {0.1f, 10}, .default_value = 1};
  static constexpr auto params = param_list(height, wave);

  void evaluate(const Batch& in, const Outputs& out) const override {
    const Floats t = in.t(), d = in.d(), radius = in.radius();
    const Floats heights = in.params[height], waves = in.params[wave];
    const FloatsOut up = out.up();
    for (std::size_t i = 0; i < in.size(); ++i) {
      const float rim = smooth_step(1 - in.stroke.distance(t[i], d[i]) / radius[i]);
      up[i] = heights[i] * radius[i] * rim * math::sin(6.2831853f * t[i] / (waves[i] * radius[i]));
    }
  }
};

BURIN_PLUGIN(Ripple);
