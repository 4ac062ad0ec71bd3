// org.burin.dashed-line: draws dashes along the stroke, as relief, colour and mask.

#include <burin/plugin/plugin.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using namespace burin::plugin;

class DashedLine : public Brush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.dashed-line",
      .name = "Dashed line",
      .vendor = "Burin",
      .version = "1.0.0",
      .help = "Draws dashes along the stroke; a whole number goes round a closed one.",
      .features = {"procedural", "vector"},
      .inputs = ink::inputs,
      .outputs = ink::outputs,
  };
  static constexpr FloatParam dash{
      .id = "dash",
      .name = "Dash",
      .help = "Length of a dash, caps included.",
      .unit = BURIN_UNIT_RADIUS,
      .hard = {0.001f, 1000},
      .soft = {0.1f, 4},
      .default_value = 1.5f,
  };
  static constexpr FloatParam gap{
      .id = "gap",
      .name = "Gap",
      .help = "Between two dashes.",
      .unit = BURIN_UNIT_RADIUS,
      .hard = {0, 1000},
      .soft = {0.1f, 4},
      .default_value = 0.75f,
  };
  static constexpr FloatParam width = common::width("Half the thickness of the line.", 0.35f, 0.001f);
  enum Caps { round, butt };
  static constexpr ChoiceParam caps{
      .id = "caps",
      .name = "Caps",
      .help = "Shape of a dash's ends.",
      .choices = {"round", "butt"},
      .default_value = round,
  };
  static constexpr auto params =
      param_list(dash, gap, width, caps, ink::height, ink::bevel, ink::colour, ink::mask);

  explicit DashedLine(StrokeStart& start)
      : dash_(start.params[dash].value() * start.stroke.radius_max()),
        period_(dash_ + start.params[gap].value() * start.stroke.radius_max()),
        caps_(start.params[caps].value()) {
    // The cap of the start shows the first dash, which changes while it grows.
    start.end_influence =
        start.stroke.closed() ? std::numeric_limits<double>::infinity() : period_ + start.stroke.radius_max();
  }

  void evaluate(const Batch& in, const Outputs& out) const override {
    const Cells cells(in);
    const Floats widths = in.params[width];
    const ink::Ink ink(in, out);
    const double period = in.stroke.whole_period(period_);
    for (std::size_t i = 0; i < in.size(); ++i) {
      const Cell cell = cells[i];
      ink.draw(i, distance(in.stroke, period, cell, widths[i] * cell.radius), cell.footprint());
    }
  }

 private:
  /// The distance to the nearest dash. The last dash of an open stroke ends with the stroke.
  float distance(const Stroke& stroke, double period, const Cell& cell, float half_width) const {
    const double t = stroke.along_line(cell.t), whole = dash_ * period / period_;
    double place = std::round((t - whole / 2) / period), dash_length = whole;
    if (stroke.has_ends()) {
      place = std::clamp(place, 0.0, std::max(std::ceil(stroke.length() / period) - 1, 0.0));
      dash_length = std::min(whole, stroke.length() - place * period);
    }
    const auto half = static_cast<float>(dash_length / 2);
    const Point p{static_cast<float>(t - place * period) - half, cell.d};
    if (caps_ == butt) return box(p, half, half_width);
    return capsule(p, std::max(half - half_width, 0.0f), half_width);
  }

  const double dash_, period_;  // object units
  const int caps_;
};

}  // namespace

BURIN_PLUGIN(DashedLine);
