// org.burin.test.greedy: a smoothing brush; wants the Laplacian, which not every host offers.
#include <burin/plugin/plugin.h>

namespace {

using namespace burin::plugin;

class GreedyBrush : public Brush {
 public:
  static constexpr BrushInfo info{.id = "org.burin.test.greedy",
                                  .name = "Greedy",
                                  .vendor = "Burin",
                                  .version = "1.0.0",
                                  .inputs = BURIN_INPUT_LAPLACIAN | BURIN_INPUT_NORMAL};

  void evaluate(const Batch& in, const Outputs& out) const override {
    const Vectors l = in.laplacian(), n = in.normal();
    const FloatsOut up = out.up();
    for (std::size_t i = 0; i < in.size(); ++i) up[i] = l.x[i] * n.x[i] + l.y[i] * n.y[i] + l.z[i] * n.z[i];
  }
};

}  // namespace

BURIN_PLUGIN(GreedyBrush);
