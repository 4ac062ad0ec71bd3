// org.burin.test.greedy: wants an input that no host of this version knows.
#include <burin/plugin/plugin.h>

namespace {

using namespace burin::plugin;

class GreedyBrush : public Brush {
 public:
  static constexpr BrushInfo info{.id = "org.burin.test.greedy",
                                  .name = "Greedy",
                                  .vendor = "Burin",
                                  .version = "1.0.0",
                                  .inputs = UINT64_C(1) << 40 | BURIN_INPUT_NORMAL};

  void evaluate(const Batch& in, const Outputs& out) const override {
    const Vectors n = in.normal();
    const FloatsOut up = out.up();
    for (std::size_t i = 0; i < in.size(); ++i) up[i] = n.x[i];
  }
};

}  // namespace

BURIN_PLUGIN(GreedyBrush);
