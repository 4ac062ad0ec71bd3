// org.burin.test.error: evaluate fails with a text after writing part of its output.
#include <burin/plugin/plugin.h>

namespace {

using namespace burin::plugin;

class ErrorBrush : public Brush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.test.error", .name = "Error", .vendor = "Burin", .version = "1.0.0"};

  void evaluate(const Batch&, const Outputs& out) const override {
    out.up()[0] = 1;
    throw Error("the error brush never works");
  }
};

}  // namespace

BURIN_PLUGIN(ErrorBrush);
