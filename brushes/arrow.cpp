// org.burin.arrow: draws one arrow as long as the stroke, the union of a circle, a rectangle and a triangle.

#include <burin/plugin/plugin.h>

#include <algorithm>
#include <limits>

namespace {

using namespace burin::plugin;

class Arrow : public Brush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.arrow",
      .name = "Arrow",
      .vendor = "Burin",
      .version = "1.0.0",
      .help = "Draws an arrow along the stroke; its head stays at the end.",
      .features = {"procedural", "vector"},
      .inputs = ink::inputs,
      .outputs = ink::outputs,
  };
  static constexpr FloatParam tail{
      .id = "tail",
      .name = "Tail",
      .help = "Radius of the circle that the arrow begins with.",
      .unit = BURIN_UNIT_RADIUS,
      .hard = {0, 1},
      .default_value = 0.45f,
  };
  static constexpr FloatParam shaft{
      .id = "shaft",
      .name = "Shaft",
      .help = "Half the thickness of the shaft.",
      .unit = BURIN_UNIT_RADIUS,
      .hard = {0.01f, 1},
      .default_value = 0.25f,
  };
  static constexpr FloatParam head_length{
      .id = "head_length",
      .name = "Head length",
      .help = "From the base of the head to the tip; an arrow shorter than that is drawn smaller.",
      .unit = BURIN_UNIT_RADIUS,
      .hard = {0.01f, 100},
      .soft = {0.2f, 5},
      .default_value = 2,
  };
  static constexpr FloatParam head_width{
      .id = "head_width",
      .name = "Head width",
      .help = "Half the width of the head's base.",
      .unit = BURIN_UNIT_RADIUS,
      .hard = {0.01f, 1},
      .default_value = 0.85f,
  };
  static constexpr auto params =
      param_list(tail, shaft, head_length, head_width, ink::height, ink::bevel, ink::colour, ink::mask);

  explicit Arrow(StrokeStart& start)
      : tail_(start.params[tail].value()),
        shaft_(start.params[shaft].value()),
        head_length_(start.params[head_length].value() * static_cast<float>(start.stroke.radius_max())),
        head_width_(start.params[head_width].value()) {
    // The head, and the bevel of a shaft that ended there.
    start.end_influence = start.stroke.closed() ? std::numeric_limits<double>::infinity()
                                                : head_length_ + 2 * start.stroke.radius_max();
  }

  void evaluate(const Batch& in, const Outputs& out) const override {
    const Cells cells(in);
    const ink::Ink ink(in, out);
    const auto length = static_cast<float>(in.stroke.dab() ? 2 * in.stroke.radius_max() : in.stroke.length());
    for (std::size_t i = 0; i < in.size(); ++i) {
      const Cell cell = cells[i];
      const float t = in.stroke.dab() ? cell.t + length / 2 : cell.t;
      float nearest = distance({t, cell.d}, length, cell.radius);
      if (in.stroke.closed()) nearest = join(nearest, distance({t - length, cell.d}, length, cell.radius));
      ink.draw(i, nearest, cell.footprint());
    }
  }

 private:
  float distance(Point p, float length, float radius) const {
    const float size = std::min(1.0f, length / head_length_);
    if (size <= 0) return circle(p, tail_ * radius);  // before the pen moves
    const float head = size * head_length_, base = size * head_width_ * radius;
    const float half = std::min(size * shaft_ * radius, base);
    const float narrow = length - head * half / base;  // t at which the head is as narrow as the shaft
    return join(join(circle(p, size * tail_ * radius), bar(p, narrow, half)),
                triangle(p - Point{length - head, 0}, head, base));
  }

  const float tail_, shaft_, head_length_, head_width_;  // radii, but head_length_ in object units
};

}  // namespace

BURIN_PLUGIN(Arrow);
