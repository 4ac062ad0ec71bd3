// org.burin.scales: tiles a stamp along and across the stroke and displaces the surface by its grey values.

#include <burin/plugin/plugin.h>

#include <algorithm>

namespace {

using namespace burin::plugin;

/// The greatest displacement, radii; hosts refuse more than 1000. A centre far from the image's values asks
/// for it.
constexpr float farthest = 999;

class Scales : public Brush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.scales",
      .name = "Scales",
      .vendor = "Burin",
      .version = "1.1.0",
      .help = "Tiles a stamp along and across the stroke.",
      .features = {"stamp"},
      .inputs = BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS | BURIN_INPUT_FOOTPRINT,
      .outputs = BURIN_OUTPUT_DISPLACEMENT,
      .overlap = BURIN_OVERLAP_LATEST,
  };
  static constexpr FileParam stamp{
      .id = "stamp",
      .name = "Stamp",
      .help = "A tileable EXR image of heights.",
  };
  static constexpr FloatParam depth = common::depth("Height that one unit of grey adds.", {-1, 1}, 0.25f);
  static constexpr FloatParam centre{
      .id = "centre",
      .name = "Centre",
      .help = "Grey value that leaves the surface where it is.",
      .hard = {-65504, 65504},
      .soft = {0, 1},
      .default_value = 0.5f,
  };
  static constexpr FloatParam tile = common::tile({0.5f, 8}, 2);
  static constexpr FloatParam aspect{
      .id = "aspect",
      .name = "Aspect",
      .help = "Widens tiles across the stroke; 1 keeps the image's aspect.",
      .hard = {0.01f, 100},
      .soft = {0.25f, 4},
      .default_value = 1,
  };
  static constexpr FloatParam fade =
      common::fade("Share of the radius over which the stamp fades out at the rim.", 0.25f);
  static constexpr FloatParam offset_along{
      .id = "offset_along",
      .name = "Offset along",
      .help = "Moves the tiles forward, by so many tiles.",
      .hard = {-1000, 1000},
      .soft = {0, 1},
      .default_value = 0,
  };
  static constexpr FloatParam offset_across{
      .id = "offset_across",
      .name = "Offset across",
      .help = "Moves the tiles to the right, by so many tiles.",
      .hard = {-1000, 1000},
      .soft = {0, 1},
      .default_value = 0,
  };
  static constexpr BoolParam mirror{
      .id = "mirror",
      .name = "Mirror",
      .help = "Mirrors every other tile, so that any image joins without a seam.",
  };
  static constexpr BoolParam flip{
      .id = "flip",
      .name = "Flip",
      .help = "Turns tiles upside down at random.",
  };
  static constexpr auto params =
      param_list(stamp, depth, centre, tile, aspect, fade, offset_along, offset_across, mirror, flip,
                 clean_stamp, stamp_layer, stamp_channel);

  explicit Scales(StrokeStart& start)
      : layout_(layout(start.params)),
        stamp_(start.host, start.params[stamp], chosen(Tiling::options(layout_), start.params)) {
    layout_.width = layout_.length * start.params[aspect].value() * stamp_.aspect();
    start.end_influence = Tiling::end_influence(layout_, start.stroke);
  }

  void evaluate(const Batch& in, const Outputs& out) const override {
    const Cells cells(in);
    const Floats depths = in.params[depth];
    const float grey_centre = in.params[centre].value(), rim = in.params[fade].value();
    const Tiling tiling(layout_, in.stroke);
    const FloatsOut up = out.up();
    stamp_.sample(
        in.size(), [&](std::size_t i) { return tiling.at(cells[i]).area; }, up);
    for (std::size_t i = 0; i < in.size(); ++i) {
      const Cell cell = cells[i];
      const float faded = rim_factor(in.stroke, cell.t, cell.d, cell.radius, rim);
      const float height = depths[i] * cell.radius * (up[i] - grey_centre) * faded;
      up[i] = std::clamp(height, -farthest * cell.radius, farthest * cell.radius);
    }
  }

 private:
  static TileLayout layout(const Params& params) {
    TileLayout layout;
    layout.length = params[tile].value();
    layout.offset_along = params[offset_along].value();
    layout.offset_across = params[offset_across].value();
    layout.mirror_along = layout.mirror_across = params[mirror].value();
    layout.flip_across = params[flip].value();
    return layout;
  }

  TileLayout layout_;
  const Stamp stamp_;
};

}  // namespace

BURIN_PLUGIN(Scales);
