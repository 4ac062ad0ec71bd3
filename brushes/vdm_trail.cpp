// org.burin.vdm-trail: places shapes from a vector displacement map along the stroke, overhangs included.

#include <burin/math/vector_axes.h>
#include <burin/plugin/plugin.h>

#include <algorithm>
#include <string>

namespace {

using namespace burin::plugin;

/// The greatest displacement along an axis, radii; hosts refuse vectors longer than 1000. A middle far from
/// the image's values asks for it.
constexpr float farthest = 576;

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
          "An image of three channels, of which each moves a place of the stamp: to the right, up or "
          "outward, in halves of the stamp's width. As the middle at its borders.",
  };
  static constexpr TextParam axes{
      .id = "axes",
      .name = "Axes",
      .help =
          "What red, green and blue hold: x to the right, y up, z outward, -z inward and so on; or the "
          "program that made the map: blender (x,y,z), cycles or mudbox (x,z,y).",
      .default_value = "x,y,z",
  };
  static constexpr FloatParam middle{
      .id = "middle",
      .name = "Middle",
      .help = "Value of the map that moves nothing: 0, or 0.5 of maps of whole numbers.",
      .hard = {-65504, 65504},
      .soft = {0, 1},
      .default_value = 0,
  };
  static constexpr FloatParam size{
      .id = "size",
      .name = "Size",
      .help = "Width of the stamp across the stroke; 2 is as wide as that. The image's aspect is kept.",
      .unit = BURIN_UNIT_RADIUS,
      .hard = {0.01f, 2},
      .soft = {0.2f, 2},
      .default_value = 2,
  };
  static constexpr FloatParam gap{
      .id = "gap",
      .name = "Gap",
      .help = "Between two stamps.",
      .unit = BURIN_UNIT_RADIUS,
      .hard = {0, 1000},
      .soft = {0, 4},
      .default_value = 0,
  };
  static constexpr FloatParam amount = common::amount(
      "1 gives the shape in the map; less flattens it in all directions.", {-10, 10}, 1, {0, 1});
  static constexpr FloatParam angle{
      .id = "angle",
      .name = "Angle",
      .help = "Turns every stamp, from the direction of travel to the left.",
      .unit = BURIN_UNIT_ANGLE,
      .hard = {-1000, 1000},
      .soft = {-3.1416f, 3.1416f},
      .default_value = 0,
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
  static constexpr auto params = param_list(stamp, axes, middle, size, gap, amount, angle, mirror, flip,
                                            clean_stamp, stamp_layer, stamp_channel);

  explicit VdmTrail(StrokeStart& start)
      : layout_(layout(start.params)),
        axes_(axes_of(start.params[axes])),
        map_(start.host, start.params[stamp], map_options(layout_, start.params)) {
    if (map_.info().channels < 3)
      throw Error(std::string(start.params[stamp]) + ": a vector displacement map has three channels");
    layout_.length = layout_.width / map_.aspect();
    // A stamp appears when the stroke reaches its middle.
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
    const auto channel = [&](std::size_t axis) { return static_cast<std::uint32_t>(axes_.channel[axis]); };
    map_.sample(in.size(), area, along, channel(0));
    map_.sample(in.size(), area, across, channel(1));
    map_.sample(in.size(), area, up, channel(2));
    for (std::size_t i = 0; i < in.size(); ++i) {
      const Tile shown = tile(i);
      const float unit = shown.on_stroke ? amounts[i] * layout_.width / 2 * cells[i].radius : 0.0f;
      const float x = axes_.sign[0] * along[i], y = axes_.sign[1] * across[i];
      const float most = farthest * cells[i].radius;
      along[i] = std::clamp(unit * shown.along(x, y), -most, most);
      across[i] = std::clamp(unit * shown.across(x, y), -most, most);
      up[i] = std::clamp(up[i] * (axes_.sign[2] * unit), -most, most);
    }
  }

 private:
  static TileLayout layout(const Params& params) {
    TileLayout layout;
    layout.width = params[size].value();  // the length follows from the image's aspect
    layout.gap = params[gap].value();
    layout.narrow = layout.single_row = true;
    layout.offset_along = -0.5f;  // the first stamp is centred at the start of the stroke
    layout.mirror_along = params[mirror].value();
    layout.flip_across = params[flip].value();
    return layout;
  }

  static math::VectorAxes axes_of(const char* text) {
    const auto found = math::vector_axes(text);
    if (!found)
      throw Error(
          std::string("axes are x, y and z in any order, as x,z,-y, or blender, cycles or mudbox, not ") +
          text);
    return *found;
  }

  static StampOptions map_options(const TileLayout& layout, const Params& params) {
    StampOptions options = chosen(Tiling::options(layout), params);
    options.zero = params[middle].value();
    return options;
  }

  TileLayout layout_;
  const math::VectorAxes axes_;
  const Stamp map_;
};

}  // namespace

BURIN_PLUGIN(VdmTrail);
