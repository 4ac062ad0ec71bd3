// org.burin.screw: makes a rod with the thread of a screw.

#include <burin/plugin/plugin.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

using namespace burin::plugin;

class Screw : public SolidBrush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.screw",
      .name = "Screw",
      .vendor = "Burin",
      .version = "1.0.0",
      .help = "Lays a threaded rod along the stroke.",
      .features = {"procedural", "solid"},
      .inputs = BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS,
      .outputs = 0,
  };
  static constexpr FloatParam width = common::whole_width("Half the width over the thread.", 0.4f);
  static constexpr FloatParam pitch{
      .id = "pitch",
      .name = "Pitch",
      .help = "Length along the stroke of one turn of the thread.",
      .unit = BURIN_UNIT_RADIUS,
      .hard = {0.02f, 10},
      .soft = {0.05f, 1},
      .default_value = 0.2f,
  };
  static constexpr FloatParam depth{
      .id = "depth",
      .name = "Depth",
      .help = "Of the thread, in pitches; a metric thread has 0.61.",
      .hard = {0.05f, 2},
      .soft = {0.05f, 1},
      .default_value = 0.61f,
  };
  static constexpr auto params = param_list(width, pitch, depth);

  explicit Screw(StrokeStart& start)
      : outer_(start.params[width].value() * static_cast<float>(start.stroke.radius_max())),
        pitch_(start.params[pitch].value() * start.stroke.radius_max()),
        depth_(std::min(start.params[depth].value() * static_cast<float>(pitch_), 0.9F * outer_)) {}

  SolidPlan solid(const Stroke&, const Params&) const override {
    return {.h_min = 0, .h_max = 2 * double{outer_}, .detail = std::min(pitch_, 2 * double{outer_})};
  }

  /// The flanks rise evenly, so that a place is as far from them as the way outward, by their slope's cosine.
  void distance(const Batch& in, Floats h, FloatsOut out) const override {
    const Floats t = in.t(), d = in.d();
    const double period = in.stroke.whole_period(pitch_);
    const auto half_pitch = static_cast<float>(period / 2);
    const float cosine = half_pitch / math::hypot(half_pitch, depth_);
    for (std::size_t i = 0; i < in.size(); ++i) {
      const Point p{d[i], h[i] - outer_};
      const double turns = t[i] / period - math::atan2(double{p.y}, double{p.x}) / (2 * std::numbers::pi);
      const auto from_crest = static_cast<float>(std::abs(turns - std::round(turns)) * 2);
      const float flank = cosine * (math::hypot(p.x, p.y) - (outer_ - depth_ * from_crest));
      out[i] = cut(flank, in.stroke.past_ends(t[i]));
    }
  }

 private:
  const float outer_;  // half width over the thread, object units
  const double pitch_;
  const float depth_;
};

}  // namespace

BURIN_PLUGIN(Screw);
