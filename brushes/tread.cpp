// org.burin.tread: prints a tyre's tread, a row of tiles as wide as the stroke, with tiles of their own at
// its start and end.

#include <burin/plugin/plugin.h>

#include <vector>

namespace {

using namespace burin::plugin;

class Tread : public Brush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.tread",
      .name = "Tread",
      .vendor = "Burin",
      .version = "1.0.0",
      .help = "Rolls a stamp as wide as the stroke along it, with stamps of its own for its start and end.",
      .features = {"stamp"},
      .inputs = BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS | BURIN_INPUT_FOOTPRINT,
      .outputs = BURIN_OUTPUT_DISPLACEMENT,
      .overlap = BURIN_OVERLAP_LATEST,
  };
  static constexpr FileParam stamp{
      .id = "stamp",
      .name = "Stamp",
      .help = "An EXR image of heights that repeats along the stroke, to the right.",
  };
  static constexpr FileParam start_stamp{
      .id = "start_stamp",
      .name = "Start stamp",
      .help = "For the first tile of an open stroke; none is needed.",
      .default_value = "",
  };
  static constexpr FileParam end_stamp{
      .id = "end_stamp",
      .name = "End stamp",
      .help = "For the last tile of an open stroke; none is needed.",
      .default_value = "",
  };
  static constexpr FileParam other_stamp{
      .id = "other_stamp",
      .name = "Other stamp",
      .help = "Stands in for the stamp in half of the tiles, at random; none is needed.",
      .default_value = "",
  };
  static constexpr FloatParam height = common::height(
      "Height that one unit of grey adds; below 0 the print is pressed in.", {-0.5f, 0.5f}, -0.15f);
  static constexpr FloatParam tile = common::tile({0.25f, 8}, 2);
  static constexpr BoolParam fit{
      .id = "fit",
      .name = "Fit",
      .help = "Stretches tiles so that an open stroke ends with a whole one; a closed one always does.",
  };
  static constexpr FloatParam fade =
      common::fade("Share of the radius over which the print fades out at the rim.", 0.06f, 0.001f);
  static constexpr auto params = param_list(stamp, start_stamp, end_stamp, other_stamp, height, tile, fit,
                                            fade, clean_stamp, stamp_layer, stamp_channel);

  explicit Tread(StrokeStart& start) {
    layout_.span(1);
    layout_.length = start.params[tile].value();
    layout_.fit = start.params[fit].value();
    add(start, stamp, Tiling::options(layout_));
    if (add(start, other_stamp, Tiling::options(layout_))) layout_.choices = 2;
    const StampOptions alone{BURIN_WRAP_CLAMP, BURIN_WRAP_UNKNOWN};
    if ((layout_.start = add(start, start_stamp, alone))) first_ = stamps_.size() - 1;
    if ((layout_.end = add(start, end_stamp, alone))) last_ = stamps_.size() - 1;
    start.end_influence = Tiling::end_influence(layout_, start.stroke);
  }

  void evaluate(const Batch& in, const Outputs& out) const override {
    const Cells cells(in);
    const Floats heights = in.params[height];
    const float rim = in.params[fade].value();
    const Tiling tiling(layout_, in.stroke);
    const FloatsOut up = out.up();
    sample_tiles(
        in.size(), [&](std::size_t i) { return tiling.at(cells[i]); },
        [&](const Tile& shown) -> const Stamp& { return stamps_[place_of(shown)]; }, up);
    for (std::size_t i = 0; i < in.size(); ++i) {
      const Cell cell = cells[i];
      const float faded = rim_factor(in.stroke, cell.t, cell.d, cell.radius, rim);
      up[i] *= heights[i] * cell.radius * faded;
    }
  }

 private:
  bool add(const StrokeStart& start, const FileParam& file, const StampOptions& options) {
    const char* path = start.params[file];
    if (*path) stamps_.emplace_back(start.host, path, chosen(options, start.params));
    return *path;
  }

  std::size_t place_of(const Tile& shown) const {
    if (shown.role == Tile::start) return first_;
    return shown.role == Tile::end ? last_ : shown.choice;
  }

  TileLayout layout_;
  std::vector<Stamp> stamps_;         // stamps to choose from, then those of the ends
  std::size_t first_ = 0, last_ = 0;  // indices of the stamps of start and end
};

}  // namespace

BURIN_PLUGIN(Tread);
