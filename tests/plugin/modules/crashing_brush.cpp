// org.burin.test.crashing: reads through a null pointer while it evaluates.
#include <burin/plugin/plugin.h>

namespace {

using namespace burin::plugin;

class CrashingBrush : public Brush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.test.crashing", .name = "Crashing", .vendor = "Burin", .version = "1.0.0"};

  void evaluate(const Batch&, const Outputs& out) const override {
    const float* volatile nothing = nullptr;
    out.up()[0] = *nothing;
  }
};

}  // namespace

BURIN_PLUGIN(CrashingBrush);
