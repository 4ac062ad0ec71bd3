// org.burin.flatten: moves points along their normals to the plane that the stroke around their foot lies in.

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
      .inputs = BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS | BURIN_INPUT_POSITION |
                BURIN_INPUT_NORMAL | BURIN_INPUT_FOOT,
      .outputs = BURIN_OUTPUT_DISPLACEMENT,
  };
  static constexpr FloatParam amount{
      .id = "amount",
      .name = "Amount",
      .help = "Share of the way to the plane.",
      .hard = {0, 1},
      .initial = 1,
      .dynamic = true,
  };
  enum Part { both, peaks, valleys };
  static constexpr ChoiceParam part{
      .id = "part",
      .name = "Part",
      .help = "What to level: both sides, only what is above the plane, or only what is below.",
      .choices = {"both", "peaks", "valleys"},
      .initial = both,
  };
  static constexpr FloatParam fade{
      .id = "fade",
      .name = "Fade",
      .help = "Share of the radius over which the brush fades out at the rim.",
      .hard = {0.01f, 1},
      .initial = 0.4f,
  };
  static constexpr auto params = param_list(amount, part, fade);

  explicit Flatten(StrokeStart& start)
      : part_(start.params[part].value()), fade_(start.params[fade].value()) {}

  void evaluate(const Batch& in, const Outputs& out) const override {
    const Floats t = in.t(), d = in.d(), radius = in.radius(), amounts = in.params[amount];
    const Vectors position = in.position(), normal = in.normal(), foot = in.foot();
    const Vectors plane_normal = in.foot_normal();
    const FloatsOut up = out.up();
    for (std::size_t i = 0; i < in.size(); ++i) {
      const float height = (position.x[i] - foot.x[i]) * plane_normal.x[i] +
                           (position.y[i] - foot.y[i]) * plane_normal.y[i] +
                           (position.z[i] - foot.z[i]) * plane_normal.z[i];
      if ((part_ == peaks && height < 0) || (part_ == valleys && height > 0)) continue;
      const float way =
          std::clamp(-height * along_normal(dot(normal, plane_normal, i)), -radius[i], radius[i]);
      up[i] = amounts[i] * rim_factor(in.stroke, t[i], d[i], radius[i], fade_) * way;
    }
  }

 private:
  /// Way along a normal that gains one unit of height over the plane, by the cosine of their angle. Beyond 60
  /// degrees less, and nothing at 90, where no way along the normal leads to the plane.
  static float along_normal(float cosine) { return cosine / std::max(cosine * cosine, 0.25f); }

  const int part_;
  const float fade_;  // share of the radius
};

}  // namespace

BURIN_PLUGIN(Flatten);
