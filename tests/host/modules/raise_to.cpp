// org.burin.test.raise-to: moves every place of the surface that it is told to the plane z = 0.1.
#include <burin/plugin/plugin.h>

namespace {

using namespace burin::plugin;

class RaiseTo : public Brush {
 public:
  static constexpr BrushInfo info{.id = "org.burin.test.raise-to",
                                  .name = "Raise to",
                                  .vendor = "Burin",
                                  .version = "1.0.0",
                                  .inputs = BURIN_INPUT_POSITION | BURIN_INPUT_NORMAL,
                                  .outputs = BURIN_OUTPUT_DISPLACEMENT};

  void evaluate(const Batch& in, const Outputs& out) const override {
    const Vectors position = in.position(), normal = in.normal();
    for (std::size_t i = 0; i < in.size(); ++i) out.up()[i] = (0.1f - position.z[i]) / normal.z[i];
  }
};

}  // namespace

BURIN_PLUGIN(RaiseTo);
