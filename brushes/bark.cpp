// org.burin.bark: adds fractal noise that is stretched along the stroke, as bark with cracks or as plain
// roughness.

#include <burin/plugin/plugin.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace burin::plugin;

class Bark : public Brush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.bark",
      .name = "Bark",
      .vendor = "Burin",
      .version = "1.0.0",
      .help = "Roughens the surface along the stroke, as finely as the mesh can show.",
      .features = {"procedural"},
      .inputs = BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS | BURIN_INPUT_FOOTPRINT,
      .outputs = BURIN_OUTPUT_DISPLACEMENT,
      .overlap = BURIN_OVERLAP_LATEST,
  };
  static constexpr FloatParam depth = common::depth("Greatest height and depth.", {0, 1}, 0.35f);
  enum Pattern { bark, noise };
  static constexpr ChoiceParam pattern{
      .id = "pattern",
      .name = "Pattern",
      .help = "Plates between sharp cracks, or plain noise.",
      .choices = {"bark", "noise"},
      .default_value = bark,
  };
  static constexpr FloatParam grain{
      .id = "grain",
      .name = "Grain",
      .help = "Width of the coarsest bumps.",
      .unit = BURIN_UNIT_RADIUS,
      .hard = {0.01f, 100},
      .soft = {0.1f, 2},
      .default_value = 0.5f,
  };
  static constexpr FloatParam stretch{
      .id = "stretch",
      .name = "Stretch",
      .help = "Length of the bumps along the stroke over their width.",
      .hard = {0.05f, 20},
      .soft = {0.5f, 8},
      .default_value = 3,
  };
  static constexpr IntParam octaves{
      .id = "octaves",
      .name = "Octaves",
      .help = "Layers of noise, each half as coarse as the one before.",
      .hard = {1, 16},
      .soft = {1, 8},
      .default_value = 6,
  };
  static constexpr FloatParam roughness{
      .id = "roughness",
      .name = "Roughness",
      .help = "Height of a layer over that of the one before.",
      .hard = {0.05f, 1},
      .default_value = 0.5f,
  };
  static constexpr FloatParam fade =
      common::fade("Share of the radius over which the noise fades out at the rim.", 0.4f);
  static constexpr auto params = param_list(depth, pattern, grain, stretch, octaves, roughness, fade);

  explicit Bark(StrokeStart& start)
      : pattern_(start.params[pattern].value()),
        width_(start.params[grain].value() * start.stroke.radius_max()),
        length_(width_ * start.params[stretch].value()),
        octaves_(start.params[octaves].value()),
        gain_(start.params[roughness].value()),
        fade_(start.params[fade].value()) {}

  void evaluate(const Batch& in, const Outputs& out) const override {
    const Floats t = in.t(), d = in.d(), radius = in.radius(), depths = in.params[depth];
    const Floats footprint_t = in.footprint_t(), footprint_d = in.footprint_d();
    const FloatsOut up = out.up();
    const double length = in.stroke.whole_period(length_);
    const auto around = in.stroke.closed() ? std::llround(in.stroke.length() / length) : 0;
    const FractalNoise fractal(in.stroke.seed(), {octaves_, gain_, around});
    for (std::size_t i = 0; i < in.size(); ++i) {
      const float height = fractal.shaped(t[i] / length, d[i] / width_, footprint_t[i] / length,
                                          footprint_d[i] / width_, [&](float n) { return shaped(n); });
      up[i] = depths[i] * radius[i] * height * rim_factor(in.stroke, t[i], d[i], radius[i], fade_);
    }
  }

 private:
  /// Makes cracks where the noise is 0. The result has mean 0, like the noise, so that octaves fade without a
  /// change of the mean height.
  float shaped(float n) const { return pattern_ == noise ? n : 0.6f - 0.16f / (std::abs(n) + 0.1f); }

  const int pattern_;
  const double width_, length_;  // size of the first octave's cells on an open stroke, object units
  const int octaves_;
  const float gain_;
  const float fade_;  // share of the radius
};

}  // namespace

BURIN_PLUGIN(Bark);
