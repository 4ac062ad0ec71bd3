// Brushes that show what reached them.
#include <burin/plugin/plugin.h>

#include <cstring>

namespace {

using namespace burin::plugin;

/// org.burin.test.params: one parameter of every type, each written to an output.
class ParamsProbe : public Brush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.test.params",
      .name = "Parameters",
      .vendor = "Burin",
      .version = "1.0.0",
      .help = "Writes its parameters.",
      .features = {"probe", "test"},
      .outputs = BURIN_OUTPUT_DISPLACEMENT | BURIN_OUTPUT_MASK | BURIN_OUTPUT_COLOUR};
  static constexpr FloatParam number{.id = "number",
                                     .name = "Number",
                                     .help = "Any.",
                                     .unit = BURIN_UNIT_ANGLE,
                                     .hard = {-100, 100},
                                     .soft = {-1, 1},
                                     .default_value = 0.5f,
                                     .dynamic = true};
  static constexpr IntParam count{
      .id = "count", .name = "Count", .hard = {-16777216, 16777216}, .soft = {0, 8}, .default_value = 3};
  static constexpr BoolParam on{.id = "on", .name = "On", .default_value = true};
  static constexpr ChoiceParam shape{
      .id = "shape", .name = "Shape", .choices = {"disc", "box", "star"}, .default_value = 2};
  static constexpr ColourParam paint{
      .id = "paint", .name = "Paint", .default_value = {0.1f, 0.2f, 0.3f, 0.4f}, .dynamic = true};
  static constexpr FileParam file{.id = "file", .name = "File", .default_value = "default.txt"};
  static constexpr float knots[] = {0, 1, 0.5f, 3, 1, 0};
  static constexpr CurveParam curve{.id = "curve", .name = "Curve", .default_value = knots};
  static constexpr TextParam text{.id = "text", .name = "Text", .default_value = "abc"};
  static constexpr auto params = param_list(number, count, on, shape, paint, file, curve, text);

  void evaluate(const Batch& in, const Outputs& out) const override {
    const Floats t = in.t();
    const Colours paints = in.params[paint];
    const ColoursOut colour = out.colour();
    for (std::size_t i = 0; i < in.size(); ++i) {
      out.along()[i] = in.params[number][i] + static_cast<float>(std::strlen(in.params[text]));
      out.across()[i] = static_cast<float>(in.params[count][i] * 10 + in.params[shape][i]);
      out.up()[i] = in.params[curve](t[i]);
      out.mask()[i] = in.params[on][i] ? static_cast<float>(std::strlen(in.params[file])) : -1;
      colour.r[i] = paints.r[i];
      colour.g[i] = paints.g[i];
      colour.b[i] = paints.b[i];
      colour.a[i] = paints.a[i];
    }
  }
};

/// org.burin.test.start: logs what a stroke begins with, asks for passes, counts its living objects.
class StartProbe : public Brush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.test.start", .name = "Start", .vendor = "Burin", .version = "1.0.0"};

  explicit StartProbe(StrokeStart& start) : log_(start.host) {
    log_.info(start.module_path);
    start.passes = 3;
    start.end_influence = 2 * start.stroke.radius_max();
  }
  ~StartProbe() override { log_.debug("end"); }

  void evaluate(const Batch& in, const Outputs& out) const override {
    for (std::size_t i = 0; i < in.size(); ++i) out.up()[i] = static_cast<float>(in.stroke.pass());
  }

 private:
  const Log log_;
};

}  // namespace

BURIN_PLUGIN(ParamsProbe, StartProbe);
