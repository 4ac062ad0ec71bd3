// org.burin.text: sets a line of text along the stroke, as relief, colour and mask.

#include <burin/plugin/plugin.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace {

using namespace burin::plugin;

class Text : public Brush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.text",
      .name = "Text",
      .vendor = "Burin",
      .version = "1.0.0",
      .help = "Sets a line of text along the stroke, its top to the left of the direction of travel.",
      .features = {"stamp", "vector", BURIN_FEATURE_ONE_HANDED},
      .inputs = ink::inputs,
      .outputs = ink::outputs,
  };
  static constexpr TextParam text{
      .id = "text",
      .name = "Text",
      .help = "What is written.",
      .default_value = "Burin",
  };
  static constexpr TextParam font{
      .id = "font",
      .name = "Font",
      .help = "Path of a font file, or the file name of one of the system's fonts.",
      .default_value = "DejaVuSans.ttf",
  };
  static constexpr FloatParam size{
      .id = "size",
      .name = "Size",
      .help = "Of an em.",
      .unit = BURIN_UNIT_RADIUS,
      .hard = {0.01f, 10},
      .soft = {0.25f, 2},
      .default_value = 1.4f,
  };
  enum Align { start, middle, end, repeat };
  static constexpr ChoiceParam align{
      .id = "align",
      .name = "Align",
      .help = "Where on the stroke the text stands; repeat fills the stroke with it.",
      .choices = {"start", "middle", "end", "repeat"},
      .default_value = start,
  };
  static constexpr FloatParam baseline{
      .id = "baseline",
      .name = "Baseline",
      .help = "Moves the text to the left; 0 centres it on the stroke.",
      .unit = BURIN_UNIT_RADIUS,
      .hard = {-10, 10},
      .soft = {-1, 1},
      .default_value = 0,
  };
  static constexpr FloatParam spacing{
      .id = "spacing",
      .name = "Spacing",
      .help = "Least distance between repeated texts.",
      .unit = BURIN_UNIT_RADIUS,
      .hard = {0, 1000},
      .soft = {0, 4},
      .default_value = 1,
  };
  static constexpr auto params =
      param_list(text, font, size, align, baseline, spacing, ink::height, ink::bevel, ink::colour, ink::mask);

  explicit Text(StrokeStart& begin)
      : lettering_(begin.host, begin.params[font], written(begin.params[text]), 128),
        size_(begin.params[size].value()),
        em_(size_ * begin.stroke.radius_max()),
        spacing_(begin.params[spacing].value() * begin.stroke.radius_max()),
        baseline_(begin.params[baseline].value()),
        align_(begin.params[align].value()) {
    if (align_ != start || begin.stroke.closed())
      begin.end_influence = std::numeric_limits<double>::infinity();
  }

  void evaluate(const Batch& in, const Outputs& out) const override {
    const Row row = lay_out(in.stroke);
    for (std::size_t first = 0; first < in.size(); first += block)
      draw(in, out, row, first, std::min(block, in.size() - first));
  }

 private:
  /// Elements at a time, whose samples fit on the stack.
  static constexpr std::size_t block = 256;

  static const char* written(const char* line) {
    if (!*line) throw Error("there is nothing to write: parameter 'text' is empty");
    return line;
  }

  /// Texts in a row: the t of the first text's start and the distance from text to text, object units.
  struct Row {
    double first, pitch, count;
  };

  /// Draws `count` elements from `first` on, at most a block.
  void draw(const Batch& in, const Outputs& out, const Row& row, std::size_t first, std::size_t count) const {
    const Cells cells(in);
    const ink::Ink ink(in, out);
    std::array<float, block> covered, rise;
    const auto sample = [&](bool sloped, std::array<float, block>& values) {
      const auto area = [&](std::size_t i) {
        Cell cell = cells[first + i];
        for (float* side : {&cell.footprint_t, &cell.footprint_d})
          if (sloped) *side = ink.slope(first + i, *side);
        return seen(in.stroke, row, cell);
      };
      lettering_.stamp().sample(count, area, FloatsOut(values.data(), 1));
    };
    sample(false, covered);
    sample(true, rise);  // blurring a letter gives its edge a slope
    for (std::size_t i = 0; i < count; ++i) {
      const Cell cell = cells[first + i];
      const float fade = rim_factor(in.stroke, cell.t, cell.d, cell.radius, 0.1f);
      ink.draw_covered(first + i, covered[i] * fade, rise[i] * fade);
    }
  }

  Row lay_out(const Stroke& stroke) const {
    const double width = lettering_.info().width * em_, length = stroke.length();
    if (stroke.dab()) return {-width / 2, width, 1};
    const double room = stroke.closed() ? length : length + spacing_;
    const double count = align_ == repeat ? std::max(1.0, std::floor(room / (width + spacing_))) : 1;
    if (stroke.closed()) return {at(align_, length - width), length / count, count};
    if (count == 1) return {at(align_, length - width), width, 1};
    return {0, (length - width) / (count - 1), count};
  }

  /// The start of a text that leaves the length `free` of the stroke unused.
  static double at(int align, double free) { return align == start ? 0 : align == end ? free : free / 2; }

  /// The area of the lettering that a cell covers in the nearest text. On a mirror image of the stroke the
  /// text runs in the opposite direction, so that it stays readable. Letters become lower where the stroke is
  /// narrower.
  StampArea seen(const Stroke& stroke, const Row& row, const Cell& cell) const {
    const burin_lettering_info& line = lettering_.info();
    const double from_first = cell.t - row.first;
    double nearest = std::round((from_first - line.width * em_ / 2) / row.pitch);
    if (!stroke.closed()) nearest = std::clamp(nearest, 0.0, row.count - 1);
    const auto along = static_cast<float>((from_first - nearest * row.pitch) / em_);
    const float shrink = cell.radius / static_cast<float>(stroke.radius_max()), em = static_cast<float>(em_);
    const float y = cell.d / (em * shrink) - baseline_ / size_ + (line.ascent - line.descent) / 2;
    const float x = stroke.mirrored() ? line.width - along : along;
    const StampPoint place = lettering_.point_at(x, y);
    return {place,
            {cell.footprint_t / em / (line.right - line.left), 0},
            {0, cell.footprint_d / (em * shrink) / (line.top - line.bottom)}};
  }

  const Lettering lettering_;
  const float size_;           // size of an em, radii
  const double em_, spacing_;  // object units
  const float baseline_;       // radii
  const int align_;
};

}  // namespace

BURIN_PLUGIN(Text);
