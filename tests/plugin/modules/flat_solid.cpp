// org.burin.test.flat-solid: what it gives as the distance to a rod changes by a quarter over a length of 1.
#include <burin/plugin/plugin.h>

namespace {

using namespace burin::plugin;

class FlatSolid : public SolidBrush {
 public:
  static constexpr BrushInfo info{.id = "org.burin.test.flat-solid",
                                  .name = "Flat solid",
                                  .vendor = "Burin",
                                  .version = "1.0.0",
                                  .inputs = BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS,
                                  .outputs = 0};

  SolidPlan solid(const Stroke& stroke, const Params&) const override {
    const double half = 0.5 * stroke.radius_max();
    return {.h_min = -half, .h_max = half, .detail = half};
  }

  void distance(const Batch& in, Floats h, FloatsOut out) const override {
    for (std::size_t i = 0; i < in.size(); ++i)
      out[i] = (math::hypot(in.d()[i], h[i]) - 0.4F * in.radius()[i]) / 4;
  }
};

}  // namespace

BURIN_PLUGIN(FlatSolid);
