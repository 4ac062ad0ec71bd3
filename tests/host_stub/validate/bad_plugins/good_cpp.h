// A brush in C++ that keeps to the ABI, with places where plugins of this folder put their fault: macros that
// they define before they include it.
#ifndef BURIN_TESTS_GOOD_CPP_H
#define BURIN_TESTS_GOOD_CPP_H

#include <burin/plugin/plugin.h>

#include <cmath>

#ifndef NAME
#define NAME "Good"
#endif
#ifndef VERSION
#define VERSION "1.0.0"
#endif
#ifndef FEATURES
#define FEATURES "procedural"
#endif
#ifndef MORE_INPUTS
#define MORE_INPUTS 0
#endif
#ifndef RIM_SLOPE
#define RIM_SLOPE 1
#endif
// Statements: when a stroke begins and ends, in evaluate, and where the height of node `i` is computed.
#ifndef IN_BEGIN
#define IN_BEGIN
#endif
#ifndef IN_END
#define IN_END
#endif
#ifndef IN_EVALUATE
#define IN_EVALUATE
#endif
#ifndef AT_NODE
#define AT_NODE
#endif
// Members of the stroke.
#ifndef MEMBERS
#define MEMBERS static_assert(true)
#endif

using namespace burin::plugin;

class GoodPlugin : public Brush {
 public:
  static constexpr BrushInfo info{
      .id = "org.example.good",
      .name = NAME,
      .vendor = "Example",
      .version = VERSION,
      .features = {FEATURES},
      .inputs = BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS | (MORE_INPUTS),
      .rim_slope = RIM_SLOPE,
  };
  static constexpr FloatParam height{.id = "height",
                                     .name = "Height",
                                     .unit = BURIN_UNIT_RADIUS,
                                     .hard = {0, 1},
                                     .default_value = 0.25f,
                                     .dynamic = true};
  static constexpr IntParam count{.id = "count", .name = "Count", .hard = {0, 9}, .default_value = 3};
  static constexpr TextParam text{.id = "text", .name = "Text", .default_value = "Burin"};
  static constexpr auto params = param_list(height, count, text);

  explicit GoodPlugin([[maybe_unused]] StrokeStart& start) { IN_BEGIN; }
  ~GoodPlugin() override { IN_END; }

  void evaluate(const Batch& in, const Outputs& out) const override {
    const Floats t = in.t(), d = in.d(), radius = in.radius(), heights = in.params[height];
    const FloatsOut up = out.up();
    for (std::size_t i = 0; i < in.size(); ++i) {
      up[i] = heights[i] * radius[i] * rim_factor(in.stroke, t[i], d[i], radius[i], 1);
      AT_NODE;
    }
    IN_EVALUATE;
  }

 private:
  MEMBERS;
};

BURIN_PLUGIN(GoodPlugin);

#endif
