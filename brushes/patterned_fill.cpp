// org.burin.patterned-fill: fills a band along the stroke with a pattern, as relief, colour and mask.

#include <burin/plugin/plugin.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using namespace burin::plugin;

/// The distance to the nearest of the lines x = 0, +-1, +-2...
float to_whole(float x) { return std::abs(x - std::round(x)); }

class PatternedFill : public Brush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.patterned-fill",
      .name = "Patterned fill",
      .vendor = "Burin",
      .version = "1.0.0",
      .help = "Fills a band along the stroke with a pattern that follows it, within an outline.",
      .features = {"procedural", "vector"},
      .inputs = ink::inputs,
      .outputs = ink::outputs,
  };
  enum Pattern { hatch, cross_hatch, checker, dots, hexagons };
  static constexpr ChoiceParam pattern{
      .id = "pattern",
      .name = "Pattern",
      .help = "What fills the band.",
      .choices = {"hatch", "cross_hatch", "checker", "dots", "hexagons"},
      .default_value = hatch,
  };
  static constexpr FloatParam cell{
      .id = "cell",
      .name = "Cell",
      .help = "Size of the pattern's period along the stroke.",
      .unit = BURIN_UNIT_RADIUS,
      .hard = {0.001f, 1000},
      .soft = {0.1f, 2},
      .default_value = 0.5f,
  };
  static constexpr FloatParam fill{
      .id = "fill",
      .name = "Fill",
      .help = "Thickness of the pattern's lines, dots and hexagons as a share of the cell.",
      .hard = {0.01f, 1},
      .default_value = 0.5f,
  };
  static constexpr FloatParam width = common::width("Half the width of the band.", 0.9f);
  static constexpr FloatParam border{
      .id = "border",
      .name = "Border",
      .help = "Thickness of the outline; 0 leaves the pattern open.",
      .unit = BURIN_UNIT_RADIUS,
      .hard = {0, 1},
      .soft = {0, 0.5f},
      .default_value = 0.12f,
  };
  static constexpr auto params =
      param_list(pattern, cell, fill, width, border, ink::height, ink::bevel, ink::colour, ink::mask);

  explicit PatternedFill(StrokeStart& start)
      : pattern_(start.params[pattern].value()),
        cell_(start.params[cell].value() * start.stroke.radius_max()),
        fill_(start.params[fill].value()),
        border_(start.params[border].value()) {
    if (start.stroke.closed()) start.end_influence = std::numeric_limits<double>::infinity();
  }

  void evaluate(const Batch& in, const Outputs& out) const override {
    const Cells cells(in);
    const Floats widths = in.params[width];
    const ink::Ink ink(in, out);
    const double length = in.stroke.whole_period(cell_);
    for (std::size_t i = 0; i < in.size(); ++i) {
      const Cell node = cells[i];
      const double column = in.stroke.along_line(node.t) / length;
      const Point p{static_cast<float>(column - std::floor(column)), static_cast<float>(node.d / cell_)};
      const float band = in.stroke.distance(node.t, node.d) - widths[i] * node.radius;
      const float inner = cut(in_cell(p) * static_cast<float>(cell_), band);
      ink.draw(i, join(inner, edge(band, node.radius)), node.footprint());
    }
  }

 private:
  float edge(float band, float radius) const {
    return border_ > 0 ? outline(band, border_ * radius) : std::numeric_limits<float>::max();
  }

  /// The distance to the pattern, in cells; the pattern has the period 1 along x.
  float in_cell(Point p) const {
    constexpr float sin45 = 0.70710678f, sin60 = 0.8660254f;
    switch (pattern_) {
      case hatch:
        return sin45 * (to_whole(p.x + p.y) - fill_ / 2);
      case cross_hatch:
        return sin45 * (std::min(to_whole(p.x + p.y), to_whole(p.x - p.y)) - fill_ / 2);
      case checker: {  // squares of half a cell, with distance 0.25 in their middles and 0 on their sides
        const float x = 0.25f - to_whole(p.x), y = 0.25f - to_whole(p.y);
        return (x > 0) == (y > 0) ? -std::min(std::abs(x), std::abs(y)) : std::min(std::abs(x), std::abs(y));
      }
      case dots:
        return staggered(p, 0.5f, [&](Point q) { return circle(q, fill_ / 2); });
      default:
        return staggered(p, sin60, [&](Point q) { return hexagon(q, fill_ / 2); });
    }
  }

  /// The distance to the nearest figure in rows `pitch` apart, every other row of which is shifted by half a
  /// period.
  template <class Figure>
  static float staggered(Point p, float pitch, const Figure& figure) {
    const float row = std::floor(p.y / pitch);
    float nearest = std::numeric_limits<float>::max();
    for (const float r : {row, row + 1}) {
      const float x = p.x - (std::fmod(r, 2.0f) != 0 ? 0.5f : 0.0f);
      nearest = join(nearest, figure({x - std::round(x), p.y - r * pitch}));
    }
    return nearest;
  }

  const int pattern_;
  const double cell_;  // object units
  const float fill_, border_;
};

}  // namespace

BURIN_PLUGIN(PatternedFill);
