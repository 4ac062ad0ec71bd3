// org.burin.test.exiting: ends the process while it evaluates.
#include <burin/plugin/plugin.h>

#include <cstdlib>

namespace {

using namespace burin::plugin;

class ExitingBrush : public Brush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.test.exiting", .name = "Exiting", .vendor = "Burin", .version = "1.0.0"};

  void evaluate(const Batch&, const Outputs&) const override { std::exit(0); }
};

}  // namespace

BURIN_PLUGIN(ExitingBrush);
