// org.burin.vdb-trail: repeats a solid from a .vdb file along the stroke.

#include <burin/plugin/plugin.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace burin::plugin;

class VdbTrail : public SolidBrush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.vdb-trail",
      .name = "VDB trail",
      .vendor = "Burin",
      .version = "1.0.0",
      .help = "Repeats a solid from an OpenVDB file along the stroke.",
      .features = {"stamp", "solid"},
      .inputs = BURIN_INPUT_T | BURIN_INPUT_D,
      .outputs = 0,
  };
  static constexpr FileParam stamp{
      .id = "stamp",
      .name = "Stamp",
      .help =
          "A .vdb file with a level set or a fog volume, whose x, y and z run along the stroke, across it "
          "and "
          "outward. The box of its active voxels is repeated.",
  };
  static constexpr TextParam grid{
      .id = "grid",
      .name = "Grid",
      .help = "Name of the grid; else the first one of floats in the file.",
  };
  static constexpr FloatParam width =
      common::whole_width("Half the width of the box across the stroke.", 0.5f);
  static constexpr FloatParam height{
      .id = "height",
      .name = "Height",
      .help = "Of the bottom of the box over the surface, in half widths.",
      .hard = {-10, 10},
      .soft = {-2, 2},
      .default_value = 0,
  };
  static constexpr BoolParam tile{
      .id = "tile",
      .name = "Tile",
      .help = "Repeats the box across the stroke too.",
  };
  static constexpr FloatParam density{
      .id = "density",
      .name = "Density",
      .help = "At the surface of a fog volume.",
      .hard = {0.0001f, 65504},
      .soft = {0.01f, 1},
      .default_value = 0.5f,
  };
  static constexpr auto params = param_list(stamp, grid, width, height, tile, density);

  explicit VdbTrail(StrokeStart& start)
      : solid_(start.host, start.params[stamp], options_of(start.params)),
        half_(start.params[width].value() * static_cast<float>(start.stroke.radius_max())),
        voxel_(2 * half_ / static_cast<float>(solid_.info().size[1])),
        bottom_(start.params[height].value() * half_),
        period_(double{voxel_} * solid_.info().size[0]) {}

  SolidPlan solid(const Stroke&, const Params&) const override {
    const double top = bottom_ + double{voxel_} * solid_.info().size[2];
    return {.h_min = bottom_, .h_max = top, .detail = 3 * double{voxel_}};
  }

  void distance(const Batch& in, Floats h, FloatsOut out) const override {
    const Floats t = in.t(), d = in.d();
    const double period = in.stroke.whole_period(period_);
    const auto place = [&](std::size_t i) -> VdbPoint {
      const double periods = t[i] / period;
      const auto x = static_cast<float>((periods - std::floor(periods)) * period_);
      return {x, d[i] + half_, h[i] - bottom_, voxel_};
    };
    solid_.sample(in.size(), place, out);
    // Where the box is squeezed along the stroke, distances are at least the file's, squeezed.
    const auto squeezed = static_cast<float>(std::min(period / period_, 1.0));
    for (std::size_t i = 0; i < in.size(); ++i) out[i] = cut(squeezed * out[i], in.stroke.past_ends(t[i]));
  }

 private:
  static VdbOptions options_of(const Params& given) {
    const std::uint32_t across = given[tile].value() ? BURIN_VDB_PERIODIC_Y : 0;
    return {BURIN_VDB_PERIODIC_X | across, given[grid], given[density].value()};
  }

  const VdbStamp solid_;
  const float half_, voxel_, bottom_;  // object units
  const double period_;                // on an open stroke
};

}  // namespace

BURIN_PLUGIN(VdbTrail);
