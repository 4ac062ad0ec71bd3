// org.burin.smooth: moves every point towards the mean of its neighbours, in several passes (Laplacian
// smoothing).

#include <burin/plugin/plugin.h>

namespace {

using namespace burin::plugin;

class Smooth : public Brush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.smooth",
      .name = "Smooth",
      .vendor = "Burin",
      .version = "1.0.0",
      .help = "Evens out bumps and dents.",
      .features = {"procedural"},
      .inputs = BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS | BURIN_INPUT_NORMAL | BURIN_INPUT_E1 |
                BURIN_INPUT_LAPLACIAN | BURIN_INPUT_DISPLACEMENT,
      .outputs = BURIN_OUTPUT_DISPLACEMENT,
  };
  static constexpr FloatParam amount = common::amount(
      "Share of the way to the middle of the neighbours that a point goes at a time.", {0, 1}, 0.5f);
  static constexpr IntParam passes{
      .id = "passes",
      .name = "Passes",
      .help = "How many times.",
      .hard = {1, 200},
      .soft = {1, 50},
      .default_value = 10,
  };
  enum Motion { free, normal };
  static constexpr ChoiceParam motion{
      .id = "motion",
      .name = "Motion",
      .help = "Freely, or along the normal alone, which leaves the spacing of the points as it is.",
      .choices = {"free", "normal"},
      .default_value = free,
  };
  static constexpr FloatParam fade =
      common::fade("Share of the radius over which the brush fades out at the rim.", 0.5f);
  static constexpr auto params = param_list(amount, passes, motion, fade);

  explicit Smooth(StrokeStart& start)
      : free_(start.params[motion].value() == free), fade_(start.params[fade].value()) {
    start.passes = static_cast<std::uint32_t>(start.params[passes].value());
  }

  void evaluate(const Batch& in, const Outputs& out) const override {
    const Floats t = in.t(), d = in.d(), radius = in.radius(), amounts = in.params[amount];
    const Vectors moved = in.displacement();
    const FloatsOut along = out.along(), across = out.across(), up = out.up();
    const Frames frames(in);
    const Vectors to_middle = in.laplacian();  // to the mean of the neighbours
    for (std::size_t i = 0; i < in.size(); ++i) {
      const float step = amounts[i] * rim_factor(in.stroke, t[i], d[i], radius[i], fade_);
      const FrameComponents way = frames.components(to_middle, i);
      along[i] = moved.x[i] + (free_ ? step * way.along : 0);
      across[i] = moved.y[i] + (free_ ? step * way.across : 0);
      up[i] = moved.z[i] + step * way.up;
    }
  }

 private:
  const bool free_;
  const float fade_;  // share of the radius
};

}  // namespace

BURIN_PLUGIN(Smooth);
