// org.burin.carve: makes a channel that is wider below the surface than at its mouth, as a solid to be taken
// away.

#include <burin/plugin/plugin.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace burin::plugin;

class Carve : public SolidBrush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.carve",
      .name = "Carve",
      .vendor = "Burin",
      .version = "1.0.0",
      .help = "Makes the solid of a channel with an undercut, to be cut out by --solid difference.",
      .features = {"procedural", "solid"},
      .inputs = BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS,
      .outputs = 0,
  };
  static constexpr FloatParam width = common::width("Half the width of the mouth.", 0.25f);
  static constexpr FloatParam depth{
      .id = "depth",
      .name = "Depth",
      .help = "Of the bottom below the surface.",
      .unit = BURIN_UNIT_RADIUS,
      .hard = {0.02f, 10},
      .soft = {0.1f, 1},
      .default_value = 0.4f,
  };
  static constexpr FloatParam undercut{
      .id = "undercut",
      .name = "Undercut",
      .help = "How much wider than its mouth the channel is, to either side, in half widths of the mouth.",
      .hard = {0, 10},
      .soft = {0, 2},
      .default_value = 0.6f,
  };
  enum Profile { dovetail, slot, round };
  static constexpr ChoiceParam profile{
      .id = "profile",
      .name = "Profile",
      .help = "Slanting walls, a T of two straight slots, or a round channel below a straight slot.",
      .choices = {"dovetail", "slot", "round"},
      .default_value = dovetail,
  };
  enum Ends { flat_ends, round_ends };
  static constexpr ChoiceParam ends{
      .id = "ends",
      .name = "Ends",
      .help = "How an open stroke ends: cut off, or as a turning cutter leaves it.",
      .choices = {"flat", "round"},
      .default_value = round_ends,
  };
  static constexpr auto params = param_list(width, depth, undercut, profile, ends);

  explicit Carve(StrokeStart& start)
      : width_(start.params[width].value()),
        depth_(start.params[depth].value() * static_cast<float>(start.stroke.radius_max())),
        wider_(1 + start.params[undercut].value()),
        profile_(start.params[profile].value()),
        ends_(start.params[ends].value()) {}

  /// Above the surface the mouth goes on by half the depth, so that nothing is left there.
  SolidPlan solid(const Stroke& stroke, const Params&) const override {
    const double mouth = 2 * width_ * std::max(stroke.radius_min(), stroke.radius_max() / 20);
    return {.h_min = -depth_, .h_max = above(), .detail = std::min(mouth, double{depth_} / 2)};
  }

  void distance(const Batch& in, Floats h, FloatsOut out) const override {
    const Floats t = in.t(), d = in.d(), radius = in.radius(), widths = in.params[width];
    for (std::size_t i = 0; i < in.size(); ++i) {
      const float past = in.stroke.past_ends(t[i]), mouth = widths[i] * radius[i];
      const float from_line = ends_ == round_ends ? math::hypot(std::max(past, 0.0f), d[i]) : std::abs(d[i]);
      const float channel = section({from_line, h[i]}, mouth, wider_ * mouth);
      out[i] = ends_ == flat_ends ? cut(channel, past) : channel;
    }
  }

 private:
  float above() const { return depth_ / 2; }

  /// x is the distance from the middle, y the height over the surface; half widths of the mouth and below.
  float section(Point p, float mouth, float below) const {
    const Point from_middle{p.x, p.y - (above() - depth_) / 2};
    const float straight = box(from_middle, mouth, (above() + depth_) / 2);
    switch (profile_) {
      case slot:
        return join(straight, box({p.x, p.y + 0.75f * depth_}, below, depth_ / 4));
      case round: {
        const float bend = std::min(below, depth_ / 2);
        return join(straight, circle({p.x, p.y + depth_ - bend}, bend));
      }
      default: {
        // The wall from the mouth at the surface to the corner below.
        const float out = below - mouth;
        const float wall = ((p.x - mouth) * depth_ + p.y * out) / math::hypot(out, depth_);
        return join(straight, cut(wall, cut(p.y, -p.y - depth_)));
      }
    }
  }

  const float width_;  // radii
  const float depth_;  // object units
  const float wider_;  // half width below over that of the mouth
  const int profile_, ends_;
};

}  // namespace

BURIN_PLUGIN(Carve);
