// org.burin.cable: makes strands that wind around a core, which fills the valleys between them halfway.

#include <burin/plugin/plugin.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

using namespace burin::plugin;

class Cable : public SolidBrush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.cable",
      .name = "Cable",
      .vendor = "Burin",
      .version = "1.0.0",
      .help = "Lays a cable of strands that wind around a core.",
      .features = {"procedural", "solid"},
      .inputs = BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS,
      .outputs = 0,
  };
  static constexpr FloatParam width = common::whole_width("Half the width of the cable.", 0.4f);
  static constexpr IntParam strands{
      .id = "strands",
      .name = "Strands",
      .help = "Number of strands around the core.",
      .hard = {2, 12},
      .default_value = 6,
  };
  static constexpr FloatParam lay{
      .id = "lay",
      .name = "Lay",
      .help = "Length along the stroke in which a strand goes around once.",
      .unit = BURIN_UNIT_RADIUS,
      .hard = {0.5f, 1000},
      .soft = {1, 10},
      .default_value = 3,
  };
  static constexpr auto params = param_list(width, strands, lay);

  explicit Cable(StrokeStart& start)
      : outer_(start.params[width].value() * static_cast<float>(start.stroke.radius_max())),
        strands_(start.params[strands].value()),
        lay_(start.params[lay].value() * start.stroke.radius_max()) {
    // Strands touch their neighbours: those of a steep lay are wide across the cable.
    const float half_step = math::sin(std::numbers::pi_v<float> / static_cast<float>(strands_));
    const float steep = slant(lay_, outer_ / (1 + half_step));
    strand_ = outer_ * half_step * steep / (1 + half_step * steep);
    ring_ = outer_ - strand_;
  }

  SolidPlan solid(const Stroke&, const Params&) const override {
    return {.h_min = 0, .h_max = 2 * double{outer_}, .detail = 2 * double{strand_}};
  }

  void distance(const Batch& in, Floats h, FloatsOut out) const override {
    const Floats t = in.t(), d = in.d();
    const double lay_length = in.stroke.whole_period(lay_ / strands_) * strands_;
    const float steep = slant(lay_length, ring_);
    for (std::size_t i = 0; i < in.size(); ++i) {
      const Point p{d[i], h[i] - outer_};
      const double turns = t[i] / lay_length;
      const float turned = 2 * std::numbers::pi_v<float> * static_cast<float>(turns - std::floor(turns));
      const float least = join(circle(p, ring_), strand(p, turned, steep));
      out[i] = cut(least, in.stroke.past_ends(t[i]));
    }
  }

 private:
  /// Cosine of the angle between a strand at this distance from the middle and the stroke.
  static float slant(double lay, float from_middle) {
    return static_cast<float>(lay / math::hypot(lay, 2 * std::numbers::pi * double{from_middle}));
  }

  /// The nearest of the strands, which have turned by this angle: of the way to its middle the part around
  /// the cable is foreshortened, since the strand runs slanting through the section.
  float strand(Point p, float turned, float steep) const {
    const float step = 2 * std::numbers::pi_v<float> / static_cast<float>(strands_);
    const float steps = (math::atan2(p.y, p.x) - turned) / step;
    const float angle = (steps - std::round(steps)) * step, far = math::hypot(p.x, p.y);
    return math::hypot(far * math::cos(angle) - ring_, far * math::sin(angle) * steep) - strand_;
  }

  const float outer_;  // half width, object units
  const int strands_;
  const double lay_;
  float strand_ = 0, ring_ = 0;  // radius of a strand, and of the circle of their middles
};

}  // namespace

BURIN_PLUGIN(Cable);
