// A brush whose second parameter has a default outside of its range. It must not compile.
#include <burin/plugin/plugin.h>

namespace {

using namespace burin::plugin;

class BadDefault : public Brush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.test.bad-default", .name = "Bad default", .vendor = "Burin", .version = "1.0.0"};
  static constexpr FloatParam width{.id = "width", .name = "Width"};
  static constexpr FloatParam height{.id = "height", .name = "Height", .hard = {0, 1}, .default_value = 2};
  static constexpr auto params = param_list(width, height);

  void evaluate(const Batch&, const Outputs&) const override {}
};

}  // namespace

BURIN_PLUGIN(BadDefault);
