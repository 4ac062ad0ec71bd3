// org.burin.zipper: makes two rows of teeth that interlock, each on a band beside the stroke.

#include <burin/plugin/plugin.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace burin::plugin;

class Zipper : public SolidBrush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.zipper",
      .name = "Zipper",
      .vendor = "Burin",
      .version = "1.0.0",
      .help = "Lays a closed zipper along the stroke: teeth from the left and the right in turn.",
      .features = {"procedural", "solid"},
      .inputs = BURIN_INPUT_T | BURIN_INPUT_D,
      .outputs = 0,
  };
  static constexpr FloatParam width = common::whole_width("Half the width, from band to band.", 0.6f);
  static constexpr FloatParam spacing{
      .id = "spacing",
      .name = "Spacing",
      .help = "From a tooth to the next on the same side, in half widths.",
      .hard = {0.2f, 1.4f},
      .default_value = 0.9f,
  };
  static constexpr FloatParam gap{
      .id = "gap",
      .name = "Gap",
      .help = "Between a tooth and its neighbours, a share of the spacing.",
      .hard = {0.03f, 0.12f},
      .default_value = 0.07f,
  };
  static constexpr FloatParam height{
      .id = "height",
      .name = "Height",
      .help = "Of the teeth over the surface, in half widths.",
      .hard = {0.05f, 2},
      .default_value = 0.35f,
  };
  static constexpr auto params = param_list(width, spacing, gap, height);

  explicit Zipper(StrokeStart& start)
      : half_(start.params[width].value() * static_cast<float>(start.stroke.radius_max())),
        spacing_(start.params[spacing].value() * half_),
        gap_(start.params[gap].value()),
        height_(start.params[height].value() * half_) {}

  SolidPlan solid(const Stroke&, const Params&) const override {
    return {.h_min = 0, .h_max = height_, .detail = std::min({3 * gap_ * spacing_, height_, half_ - band()})};
  }

  void distance(const Batch& in, Floats h, FloatsOut out) const override {
    const Floats t = in.t(), d = in.d();
    const double period = in.stroke.whole_period(spacing_);
    const auto pitch = static_cast<float>(period), first = pitch / 4, second = 3 * first;
    for (std::size_t i = 0; i < in.size(); ++i) {
      const float left = tooth({from_tooth(in.stroke, t[i] - first, period), d[i]}, pitch);
      const float right = tooth({from_tooth(in.stroke, t[i] - second, period), -d[i]}, pitch);
      const float teeth = cut(join(left, right), std::abs(h[i] - height_ / 2) - height_ / 2);
      out[i] = join(teeth, bands(d[i], h[i], in.stroke.past_ends(t[i])));
    }
  }

 private:
  float band() const { return 0.75f * half_; }

  /// The offset from the nearest tooth of one side, for one from where its first tooth is. An open stroke has
  /// as many teeth on either side as whole spacings.
  static float from_tooth(const Stroke& stroke, float t, double period) {
    double tooth = std::round(t / period);
    if (!stroke.closed())
      tooth = std::clamp(tooth, 0.0, std::max(std::floor(stroke.length() / period) - 1, 0.0));
    return static_cast<float>(t - tooth * period);
  }

  /// A tooth from its band at y > 0 to a round head across the middle. Heads are as large as the gaps to the
  /// two heads beside them allow, and too large to slip out between them; the neck leaves the gap to both.
  float tooth(Point p, float period) const {
    const float across = 0.2f * period;
    const float head = (math::hypot(0.5f, 0.4f) - gap_) / 2 * period;
    const float neck = (0.5f - gap_) * period - head;
    const float middle = (half_ - across) / 2;
    return join(circle({p.x, p.y + across}, head), box({p.x, p.y - middle}, neck, half_ - middle));
  }

  /// The two bands that hold the teeth, half as high.
  float bands(float d, float h, float past_ends) const {
    const float middle = (half_ + band()) / 2;
    return cut(box({std::abs(d) - middle, h - height_ / 4}, half_ - middle, height_ / 4), past_ends);
  }

  const float half_, spacing_;  // object units
  const float gap_;             // spacings
  const float height_;          // object units
};

}  // namespace

BURIN_PLUGIN(Zipper);
