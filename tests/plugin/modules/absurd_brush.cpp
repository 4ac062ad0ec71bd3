// org.burin.test.absurd: displaces by so many radii, farther than any brush has reason to.
#include <burin/plugin/plugin.h>

namespace {

using namespace burin::plugin;

class AbsurdBrush : public Brush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.test.absurd", .name = "Absurd", .vendor = "Burin", .version = "1.0.0"};
  static constexpr FloatParam radii{
      .id = "radii", .name = "Radii", .hard = {0, 3e38f}, .default_value = 1001};
  static constexpr auto params = param_list(radii);

  void evaluate(const Batch& in, const Outputs& out) const override {
    for (std::size_t i = 0; i < in.size(); ++i) out.along()[i] = -in.params[radii][i] * in.radius()[i];
  }
};

}  // namespace

BURIN_PLUGIN(AbsurdBrush);
