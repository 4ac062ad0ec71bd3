// org.burin.test.nan: displaces by NaN.
#include <burin/plugin/plugin.h>

#include <limits>

namespace {

using namespace burin::plugin;

class NanBrush : public Brush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.test.nan", .name = "NaN", .vendor = "Burin", .version = "1.0.0"};

  void evaluate(const Batch& in, const Outputs& out) const override {
    for (std::size_t i = 0; i < in.size(); ++i) out.up()[i] = std::numeric_limits<float>::quiet_NaN();
  }
};

}  // namespace

BURIN_PLUGIN(NanBrush);
