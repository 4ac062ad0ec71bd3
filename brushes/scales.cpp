// org.burin.scales: tiles a stamp along and across the stroke and displaces the surface by its grey values.

#include <burin/plugin/plugin.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using namespace burin::plugin;

class Scales : public Brush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.scales",
      .name = "Scales",
      .vendor = "Burin",
      .version = "1.0.0",
      .help = "Tiles a stamp along and across the stroke.",
      .features = {"stamp"},
      .inputs = BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS,
      .outputs = BURIN_OUTPUT_DISPLACEMENT,
  };
  static constexpr FileParam stamp{
      .id = "stamp",
      .name = "Stamp",
      .help = "A tileable EXR image of heights.",
  };
  static constexpr FloatParam depth{
      .id = "depth",
      .name = "Depth",
      .help = "Height that one unit of grey adds.",
      .unit = BURIN_UNIT_RADIUS,
      .hard = {-10, 10},
      .soft = {-1, 1},
      .initial = 0.25f,
      .dynamic = true,
  };
  static constexpr FloatParam centre{
      .id = "centre",
      .name = "Centre",
      .help = "Grey value that leaves the surface where it is.",
      .hard = {-65504, 65504},
      .soft = {0, 1},
      .initial = 0.5f,
  };
  static constexpr FloatParam tile{
      .id = "tile",
      .name = "Tile",
      .help = "Length of a tile along the stroke.",
      .unit = BURIN_UNIT_RADIUS,
      .hard = {0.01f, 1000},
      .soft = {0.5f, 8},
      .initial = 2,
  };
  static constexpr FloatParam aspect{
      .id = "aspect",
      .name = "Aspect",
      .help = "Widens tiles across the stroke; 1 keeps the image's aspect.",
      .hard = {0.01f, 100},
      .soft = {0.25f, 4},
      .initial = 1,
  };
  static constexpr FloatParam fade{
      .id = "fade",
      .name = "Fade",
      .help = "Share of the radius over which the stamp fades out at the rim.",
      .hard = {0.01f, 1},
      .initial = 0.25f,
  };
  static constexpr auto params = param_list(stamp, depth, centre, tile, aspect, fade);

  explicit Scales(StrokeStart& start)
      : stamp_(start.host, start.params[stamp]),
        tile_(start.params[tile].value() * start.stroke.radius_max()),
        aspect_(start.params[aspect].value() * stamp_.aspect()) {
    if (start.stroke.closed()) start.end_influence = std::numeric_limits<double>::infinity();
  }

  void evaluate(const Batch& in, const Outputs& out) const override {
    const Floats t = in.t(), d = in.d(), radius = in.radius(), depths = in.params[depth];
    const float grey_centre = in.params[centre].value(), rim = in.params[fade].value();
    const double along = tile_length(in.stroke), across = tile_ * aspect_;
    const FloatsOut up = out.up();
    const auto place = [&](std::size_t
                               i) {  // the middle row of a tile runs along the stroke, its top on the left
      return StampArea{{static_cast<float>(t[i] / along), static_cast<float>(0.5 - d[i] / across)}, {}, {}};
    };
    stamp_.sample(in.size(), place, up);
    for (std::size_t i = 0; i < in.size(); ++i) {
      const float faded = smooth_step((1 - in.stroke.distance(t[i], d[i]) / radius[i]) / rim);
      up[i] = depths[i] * radius[i] * (up[i] - grey_centre) * faded;
    }
  }

 private:
  /// Whole tiles go round a closed stroke.
  double tile_length(const Stroke& stroke) const {
    if (!stroke.closed() || stroke.length() == 0) return tile_;
    return stroke.length() / std::max(1.0, std::round(stroke.length() / tile_));
  }

  const Stamp stamp_;
  const double tile_;    // length of an open stroke's tiles, object units
  const double aspect_;  // width across the stroke over length along it
};

}  // namespace

BURIN_PLUGIN(Scales);
