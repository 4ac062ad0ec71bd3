// org.burin.patterned-line: draws a row of equal figures along the stroke, as relief, colour and mask.

#include <burin/plugin/plugin.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace {

using namespace burin::plugin;

class PatternedLine : public Brush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.patterned-line",
      .name = "Patterned line",
      .vendor = "Burin",
      .version = "1.0.0",
      .help = "Repeats a figure along the stroke, whole ones only.",
      .features = {"procedural", "vector"},
      .inputs = ink::inputs,
      .outputs = ink::outputs,
  };
  enum Figure { dots, diamonds, triangles, waves, chain };
  static constexpr ChoiceParam figure{
      .id = "figure",
      .name = "Figure",
      .help = "What is repeated; triangles point along the stroke.",
      .choices = {"dots", "diamonds", "triangles", "waves", "chain"},
      .default_value = diamonds,
  };
  static constexpr FloatParam spacing{
      .id = "spacing",
      .name = "Spacing",
      .help = "Distance from one figure to the next.",
      .unit = BURIN_UNIT_RADIUS,
      .hard = {0.001f, 1000},
      .soft = {0.25f, 4},
      .default_value = 1.5f,
  };
  static constexpr FloatParam fill{
      .id = "fill",
      .name = "Fill",
      .help = "Length of a figure as a share of the spacing.",
      .hard = {0.01f, 1},
      .default_value = 0.9f,
  };
  static constexpr FloatParam width =
      common::width("Half of a figure's size across the stroke.", 0.5f, 0.001f);
  static constexpr FloatParam line{
      .id = "line",
      .name = "Line",
      .help = "Thickness of the lines that waves and chains are made of, as a share of the width.",
      .hard = {0.01f, 1},
      .default_value = 0.4f,
  };
  static constexpr auto params =
      param_list(figure, spacing, fill, width, line, ink::height, ink::bevel, ink::colour, ink::mask);

  explicit PatternedLine(StrokeStart& start)
      : figure_(start.params[figure].value()),
        spacing_(start.params[spacing].value() * start.stroke.radius_max()),
        fill_(start.params[fill].value()),
        line_(start.params[line].value()) {
    start.end_influence = start.stroke.closed() ? std::numeric_limits<double>::infinity() : 2 * spacing_;
  }

  void evaluate(const Batch& in, const Outputs& out) const override {
    const Cells cells(in);
    const Floats widths = in.params[width];
    const ink::Ink ink(in, out);
    const double length = in.stroke.whole_period(spacing_);
    for (std::size_t i = 0; i < in.size(); ++i) {
      const Cell cell = cells[i];
      ink.draw(i, nearest(in.stroke, length, cell, widths[i] * cell.radius), cell.footprint());
    }
  }

 private:
  /// The distance to the nearer of the two figures around the node, among the figures that fit into the
  /// stroke.
  float nearest(const Stroke& stroke, double length, const Cell& cell, float half_width) const {
    const double t = stroke.along_line(cell.t), place = std::round(t / length);
    const double last = std::max(std::floor(stroke.length() / length) - 1, 0.0);
    const auto to = [&](double column) {
      if (stroke.has_ends()) column = std::clamp(column, 0.0, last);
      const Point from_middle{static_cast<float>(t - (column + 0.5) * length), cell.d};
      return distance(from_middle, static_cast<float>(length), half_width);
    };
    return join(to(place - 1), to(place));
  }

  /// The distance to a figure centred at the origin.
  float distance(Point p, float length, float half_width) const {
    const float half = fill_ * length / 2, stroke = line_ * half_width;
    switch (figure_) {
      case dots:
        return circle(p, std::min(half, half_width));
      case diamonds:
        return diamond(p, half, half_width);
      case triangles:
        return triangle(p - Point{-half, 0}, 2 * half, half_width);
      case waves:
        return wave(p, length, half_width - stroke / 2) - stroke / 2;
      default:
        return links(p, length, half_width, stroke);
    }
  }

  /// The distance to one period of a sine curve, to first order; outside the period, the distance to its end.
  static float wave(Point p, float length, float amplitude) {
    const float beyond = std::abs(p.x) - length / 2;
    if (beyond > 0) return math::hypot(beyond, p.y);
    const float k = 2 * std::numbers::pi_v<float> / length;
    const float slope = amplitude * k * math::cos(k * p.x);
    return std::abs(p.y - amplitude * math::sin(k * p.x)) / math::hypot(1.0f, slope);
  }

  /// The distance to a ring in the middle and to half of each of the side-on links that join it to its
  /// neighbours.
  static float links(Point p, float length, float half_width, float thickness) {
    const float straight = std::max(0.35f * length - half_width, 0.0f);
    const float ring = outline(capsule(p, straight, half_width), thickness);
    const Point from_joint{std::abs(p.x) - length / 2, p.y};
    const float half_bar = from_joint.x < 0 ? std::max(0.25f * length - thickness / 2, 0.0f) : 0.0f;
    const float bar = capsule(from_joint, half_bar, thickness / 2);
    return join(ring, bar);
  }

  const int figure_;
  const double spacing_;  // object units
  const float fill_, line_;
};

}  // namespace

BURIN_PLUGIN(PatternedLine);
