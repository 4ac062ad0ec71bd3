// org.burin.vdm-trail: a trail of shapes from a vector displacement map, overhangs and all.

#include <burin/plugin/plugin.h>

#include <algorithm>
#include <string>

namespace {

using namespace burin::plugin;

class VdmTrail : public Brush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.vdm-trail",
      .name = "VDM trail",
      .vendor = "Burin",
      .version = "1.0.0",
      .help = "Repeats a vector displacement map along the stroke.",
      .features = {"stamp", "vector displacement"},
      .inputs = BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS | BURIN_INPUT_FOOTPRINT,
      .outputs = BURIN_OUTPUT_DISPLACEMENT,
      .overlap = BURIN_OVERLAP_LATEST,
  };
  static constexpr FileParam stamp{
      .id = "stamp",
      .name = "Stamp",
      .help =
          "An EXR image; red, green and blue move a place of the stamp to the right, up and outward, in "
          "halves of the stamp's width. 0 at its borders.",
  };
  static constexpr FloatParam size{
      .id = "size",
      .name = "Size",
      .help = "Width of the stamp; 2 is as wide as the stroke.",
      .unit = BURIN_UNIT_RADIUS,
      .hard = {0.01f, 2},
      .soft = {0.2f, 2},
      .initial = 2,
  };
  static constexpr FloatParam gap{
      .id = "gap",
      .name = "Gap",
      .help = "Between two stamps.",
      .unit = BURIN_UNIT_RADIUS,
      .hard = {0, 1000},
      .soft = {0, 4},
      .initial = 0,
  };
  static constexpr FloatParam amount{
      .id = "amount",
      .name = "Amount",
      .help = "1 gives the shape in the map; less flattens it in all directions.",
      .hard = {-10, 10},
      .soft = {0, 1},
      .initial = 1,
      .dynamic = true,
  };
  static constexpr FloatParam angle{
      .id = "angle",
      .name = "Angle",
      .help = "Turns every stamp, from the direction of travel to the left.",
      .unit = BURIN_UNIT_ANGLE,
      .hard = {-1000, 1000},
      .soft = {-3.1416f, 3.1416f},
      .initial = 0,
      .dynamic = true,
  };
  static constexpr BoolParam mirror{
      .id = "mirror",
      .name = "Mirror",
      .help = "Mirrors every other stamp along the stroke.",
  };
  static constexpr BoolParam flip{
      .id = "flip",
      .name = "Flip",
      .help = "Mirrors stamps across the stroke at random.",
  };
  static constexpr auto params = param_list(stamp, size, gap, amount, angle, mirror, flip, clean_stamp);

  explicit VdmTrail(StrokeStart& start)
      : layout_(layout(start.params)),
        map_(start.host, start.params[stamp], cleaned(Tiling::options(layout_), start.params)) {
    if (map_.info().channels < 3)
      throw Error(std::string(start.params[stamp]) + ": a vector displacement map has three channels");
    // A stamp is there from the moment on when the stroke reaches its middle.
    const double half_pitch = (layout_.length + layout_.gap) / 2 * start.stroke.radius_max();
    start.end_influence = std::max(Tiling::end_influence(layout_, start.stroke), half_pitch);
  }

  void evaluate(const Batch& in, const Outputs& out) const override {
    const Cells cells(in);
    const Floats amounts = in.params[amount], angles = in.params[angle];
    const Tiling tiling(layout_, in.stroke);
    const auto tile = [&](std::size_t i) { return tiling.at(cells[i], angles[i]); };
    const auto area = [&](std::size_t i) { return tile(i).area; };
    const FloatsOut along = out.along(), across = out.across(), up = out.up();
    map_.sample(in.size(), area, along, 0);
    map_.sample(in.size(), area, across, 1);
    map_.sample(in.size(), area, up, 2);
    for (std::size_t i = 0; i < in.size(); ++i) {
      const Tile shown = tile(i);
      const float unit = shown.on_stroke ? amounts[i] * layout_.width / 2 * cells[i].radius : 0.0f;
      const float x = along[i], y = across[i];
      along[i] = unit * shown.along(x, y);
      across[i] = unit * shown.across(x, y);
      up[i] *= unit;
    }
  }

 private:
  static TileLayout layout(const Params& params) {
    TileLayout layout;
    layout.length = layout.width = params[size].value();
    layout.gap = params[gap].value();
    layout.narrow = layout.single_row = true;
    layout.offset_along = -0.5f;  // one stamp stands where the stroke begins
    layout.mirror_along = params[mirror].value();
    layout.flip_across = params[flip].value();
    return layout;
  }

  const TileLayout layout_;
  const Stamp map_;
};

}  // namespace

BURIN_PLUGIN(VdmTrail);
