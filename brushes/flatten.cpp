// org.burin.flatten: moves points, with all relief on them, straight to the plane in which the stroke lies
// near their foot.

#include <burin/plugin/plugin.h>

#include <algorithm>

namespace {

using namespace burin::plugin;

class Flatten : public Brush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.flatten",
      .name = "Flatten",
      .vendor = "Burin",
      .version = "1.0.0",
      .help = "Levels what is above and below the stroke.",
      .features = {"procedural"},
      .inputs = BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS | BURIN_INPUT_FINE_POSITION |
                BURIN_INPUT_NORMAL | BURIN_INPUT_E1 | BURIN_INPUT_FOOT,
      .outputs = BURIN_OUTPUT_DISPLACEMENT,
      // Visits of one place have planes of their own, and together they level it to one between them.
      .overlap = BURIN_OVERLAP_AVERAGE,
  };
  static constexpr FloatParam amount = common::amount("Share of the way to the plane.", {0, 1}, 1);
  enum Part { both, peaks, valleys };
  static constexpr ChoiceParam part{
      .id = "part",
      .name = "Part",
      .help = "What to level: both sides, only what is above the plane, or only what is below.",
      .choices = {"both", "peaks", "valleys"},
      .default_value = both,
  };
  static constexpr FloatParam fade =
      common::fade("Share of the radius over which the brush fades out at the rim.", 0.4f);
  static constexpr auto params = param_list(amount, part, fade);

  explicit Flatten(StrokeStart& start)
      : part_(start.params[part].value()), fade_(start.params[fade].value()) {}

  void evaluate(const Batch& in, const Outputs& out) const override {
    const Floats t = in.t(), d = in.d(), radius = in.radius(), amounts = in.params[amount];
    const Vectors position = in.fine_position(), foot = in.foot(), plane_normal = in.foot_normal();
    const FloatsOut along = out.along(), across = out.across(), up = out.up();
    const Frames frames(in);
    for (std::size_t i = 0; i < in.size(); ++i) {
      const float height = (position.x[i] - foot.x[i]) * plane_normal.x[i] +
                           (position.y[i] - foot.y[i]) * plane_normal.y[i] +
                           (position.z[i] - foot.z[i]) * plane_normal.z[i];
      if ((part_ == peaks && height < 0) || (part_ == valleys && height > 0)) continue;
      const float share = amounts[i] * rim_factor(in.stroke, t[i], d[i], radius[i], fade_);
      const float way = share * std::clamp(-height, -radius[i], radius[i]);
      const FrameComponents outward = frames.components(plane_normal, i);
      along[i] = way * outward.along;
      across[i] = way * outward.across;
      up[i] = way * outward.up;
    }
  }

 private:
  const int part_;
  const float fade_;  // share of the radius
};

}  // namespace

BURIN_PLUGIN(Flatten);
