// org.burin.wave: draws a rounded bead or groove along a sine wave, whose middle line is the drawn stroke.

#include <burin/plugin/plugin.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

using namespace burin::plugin;

class Wave : public Brush, public CurveFilter {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.wave",
      .name = "Wave",
      .vendor = "Burin",
      .version = "1.0.0",
      .help = "Raises a bead, or sinks a groove, along a sine wave around the drawn line.",
      .features = {"procedural", "curve"},
      .inputs = BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS,
      .outputs = BURIN_OUTPUT_DISPLACEMENT,
      .rim_slope = 11.86f,  // of (1 - x^2)^2, 32/27, with the greatest height
  };
  static constexpr FloatParam height =
      common::height("Height along the middle; below 0 a groove.", {-0.5f, 0.5f}, 0.2f);
  static constexpr FloatParam width = common::width("Distance from the middle to the rim.", 0.35f);
  static constexpr FloatParam amplitude{
      .id = "amplitude",
      .name = "Amplitude",
      .help = "How far the wave swings to either side of the drawn line.",
      .unit = BURIN_UNIT_RADIUS,
      .hard = {0, 10},
      .soft = {0, 2},
      .default_value = 0.6f,
  };
  static constexpr FloatParam wavelength{
      .id = "wavelength",
      .name = "Wavelength",
      .help =
          "Length of a wave along the drawn line; around a closed stroke there is a whole number of them.",
      .unit = BURIN_UNIT_RADIUS,
      .hard = {0.1f, 1000},
      .soft = {1, 10},
      .default_value = 3,
  };
  static constexpr auto params = param_list(height, width, amplitude, wavelength);

  explicit Wave(StrokeStart& start)
      : amplitude_(start.params[amplitude].value() * static_cast<float>(start.stroke.radius_max())),
        wavelength_(start.params[wavelength].value() * start.stroke.radius_max()) {}

  /// Across the line, by the sine of t.
  void move(const CurvePoints& points, FloatsOut, FloatsOut across) const override {
    const Floats t = points.t();
    const double length = points.stroke.whole_period(wavelength_);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double waves = t[i] / length;
      across[i] = amplitude_ * turn_sine(static_cast<float>(waves - std::floor(waves)));
    }
  }

  /// A bead along the wave.
  void evaluate(const Batch& in, const Outputs& out) const override {
    const Floats t = in.t(), d = in.d(), radius = in.radius();
    const Floats heights = in.params[height], widths = in.params[width];
    const FloatsOut up = out.up();
    for (std::size_t i = 0; i < in.size(); ++i) {
      const float x = in.stroke.distance(t[i], d[i]) / (widths[i] * radius[i]);
      const float inside = std::max(1 - x * x, 0.0f);
      up[i] = heights[i] * radius[i] * inside * inside;
    }
  }

 private:
  static float turn_sine(float turns) { return math::sin(2 * std::numbers::pi_v<float> * turns); }

  const float amplitude_;    // object units
  const double wavelength_;  // of an open stroke, object units
};

}  // namespace

BURIN_PLUGIN(Wave);
