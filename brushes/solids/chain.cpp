// org.burin.chain: makes interlocked links, each a ring with straight sides, tilted in turn to the left and
// right.

#include <burin/plugin/plugin.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

using namespace burin::plugin;

class Chain : public SolidBrush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.chain",
      .name = "Chain",
      .vendor = "Burin",
      .version = "1.0.0",
      .help = "Lays a chain of interlocked links along the stroke.",
      .features = {"procedural", "solid"},
      .inputs = BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS,
      .outputs = 0,
  };
  static constexpr FloatParam width = common::whole_width("Half the outer width of a link.", 0.5f);
  static constexpr FloatParam wire{
      .id = "wire",
      .name = "Wire",
      .help = "Thickness of the wire, a share of the link's width.",
      .hard = {0.1f, 0.32f},
      .default_value = 0.27f,
  };
  static constexpr FloatParam gap{
      .id = "gap",
      .name = "Gap",
      .help = "Between a link and the next, where they are closest; in thicknesses of the wire.",
      .hard = {0.05f, 1},
      .default_value = 0.2f,
  };
  static constexpr FloatParam length{
      .id = "length",
      .name = "Length",
      .help = "From link to link, in widths of a link.",
      .hard = {0.95f, 10},
      .soft = {0.95f, 3},
      .default_value = 1.1f,
  };
  static constexpr auto params = param_list(width, wire, gap, length);

  explicit Chain(StrokeStart& start)
      : outer_(start.params[width].value() * static_cast<float>(start.stroke.radius_max())),
        wire_(start.params[wire].value() * outer_),
        bend_(outer_ - wire_),
        gap_(2 * wire_ * start.params[gap].value()),
        pitch_(2 * outer_ * start.params[length].value()) {}

  /// Links lean by half a right angle, so that all of them touch the ground.
  SolidPlan solid(const Stroke&, const Params&) const override {
    return {.h_min = 0, .h_max = 2 * double{height()}, .detail = std::min(2 * wire_, 3 * gap_)};
  }

  void distance(const Batch& in, Floats h, FloatsOut out) const override {
    const Floats t = in.t(), d = in.d();
    const Links links = links_of(in.stroke);
    for (std::size_t i = 0; i < in.size(); ++i) {
      const float up = h[i] - height();
      const double nearest = std::round((t[i] - links.first) / links.pitch);
      float least = std::numeric_limits<float>::max();
      for (double link = nearest - 1; link <= nearest + 1; ++link) {
        if (links.count > 0 && !(link >= 0 && link < links.count)) continue;
        const auto along = static_cast<float>(t[i] - (links.first + link * links.pitch));
        const float side = std::fmod(std::abs(link), 2.0) == 0 ? 1.0F : -1.0F;
        constexpr float diagonal = std::numbers::sqrt2_v<float> / 2;
        least = join(least, ring(links, along, diagonal * (d[i] + side * up), diagonal * (up - side * d[i])));
      }
      out[i] = least;
    }
  }

 private:
  struct Links {
    double pitch;     ///< from middle to middle
    double first;     ///< t of the first one's middle
    double count;     ///< 0: all around
    float half_side;  ///< of a straight side
  };

  float height() const { return std::numbers::sqrt2_v<float> / 2 * bend_ + wire_; }

  /// Whole links; around a closed stroke an even number of them, as each second one leans the other way. The
  /// straight sides are as long as it takes for the gap.
  Links links_of(const Stroke& stroke) const {
    Links links{pitch_, 0, 0, 0};
    if (stroke.closed()) {
      links.pitch = stroke.length() / (2 * std::max(1.0, std::round(stroke.length() / (2 * pitch_))));
    } else {
      const double reach = half_length(pitch_);
      links.count = std::max(1.0, std::floor((stroke.length() - 2 * reach) / pitch_) + 1);
      links.first = (stroke.length() - (links.count - 1) * pitch_) / 2;
    }
    links.half_side = std::max(static_cast<float>(half_length(links.pitch)) - bend_, 0.0F);
    return links;
  }

  /// From the middle of a link to the middle of its wire at the end: links of this pitch then keep the gap.
  double half_length(double pitch) const { return pitch / 2 + wire_ + gap_ / 2; }

  /// A ring in the plane of x and y, z from it.
  float ring(const Links& links, float x, float y, float z) const {
    const float past_side = std::max(std::abs(x) - links.half_side, 0.0F);
    return math::hypot(math::hypot(past_side, y) - bend_, z) - wire_;
  }

  const float outer_, wire_;  // half widths of link and wire, object units
  const float bend_;          // radius of the wire's middle line at a link's ends
  const float gap_;
  const float pitch_;
};

}  // namespace

BURIN_PLUGIN(Chain);
