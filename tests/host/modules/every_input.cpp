// org.burin.test.every-input: mixes every input that hosts offer today into its outputs, in three passes, and
// looks at the stroke's length and end within one radius of the end.
#include <burin/plugin/plugin.h>

namespace {

using namespace burin::plugin;

class EveryInput : public Brush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.test.every-input",
      .name = "Every input",
      .vendor = "Burin",
      .version = "1.0.0",
      .inputs = BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS | BURIN_INPUT_STRETCH | BURIN_INPUT_SHEET |
                BURIN_INPUT_VISIT_COUNT | BURIN_INPUT_POSITION | BURIN_INPUT_NORMAL | BURIN_INPUT_E1 |
                BURIN_INPUT_DISPLACEMENT | BURIN_INPUT_NODE_ID | BURIN_INPUT_PRESSURE | BURIN_INPUT_TILT |
                BURIN_INPUT_TWIST | BURIN_INPUT_SPEED | BURIN_INPUT_TIME | BURIN_INPUT_FOOTPRINT |
                BURIN_INPUT_MEAN_CURVATURE | BURIN_INPUT_LAPLACIAN | BURIN_INPUT_MASK | BURIN_INPUT_COLOUR |
                BURIN_INPUT_SYMMETRY | BURIN_INPUT_FOOT | BURIN_INPUT_FINE_POSITION |
                BURIN_INPUT_FINE_NORMAL | BURIN_INPUT_FINE_MEAN_CURVATURE | BURIN_INPUT_END_DISTANCE,
      .outputs = BURIN_OUTPUT_DISPLACEMENT | BURIN_OUTPUT_MASK | BURIN_OUTPUT_COLOUR};

  explicit EveryInput(StrokeStart& start) {
    start.passes = 3;
    start.end_influence = start.stroke.radius_max();
  }

  void evaluate(const Batch& in, const Outputs& out) const override {
    const auto t = in.t(), d = in.d(), radius = in.radius(), pressure = in.pressure(), tilt_x = in.tilt_x(),
               tilt_y = in.tilt_y(), twist = in.twist(), speed = in.speed(), time = in.time();
    const auto position = in.position(), normal = in.normal(), e1 = in.e1(), displacement = in.displacement();
    const auto stretch = in.stretch(), mask = in.mask();
    const auto node = in.node_id(), sheet = in.sheet(), visits = in.visit_count();
    const auto laplacian = in.laplacian();
    const auto along = out.along(), across = out.across(), up = out.up();
    for (std::size_t i = 0; i < in.size(); ++i) {
      const float rim = 1 - d[i] * d[i] / (radius[i] * radius[i]);
      const float pen = pressure[i] + tilt_x[i] - tilt_y[i] + twist[i] + speed[i] * 0.1f + time[i] * 0.1f;
      const float place = position.x[i] * normal.x[i] + position.y[i] * e1.y[i] + position.z[i] * normal.z[i];
      const auto names = static_cast<float>(node[i] % 7 + sheet[i] + 3 * visits[i]) + stretch[i];
      const float around = laplacian.z[i] + surroundings(in, i);
      out.mask()[i] = mask[i] * rim;
      out.colour().r[i] = rim;
      out.colour().a[i] = in.colour().a[i] + 0.5f * rim;
      up[i] =
          0.01f * (around + rim * pen + 0.1f * place + 0.1f * names + 0.1f * t[i]) + 0.5f * displacement.z[i];
      along[i] = 0.01f * end(in.stroke, t[i]);
      across[i] = 0.5f * displacement.x[i];
    }
  }

 private:
  static float surroundings(const Batch& in, std::size_t i) {
    const float size = in.footprint_t()[i] + in.footprint_d()[i];
    const float foot = in.foot().x[i] + in.foot_normal().z[i];
    const float relief = in.end_distance()[i] + in.fine_position().z[i] + in.fine_normal().x[i] +
                         size * in.fine_mean_curvature()[i];
    return size + foot + relief + size * in.mean_curvature()[i] + 0.1f * static_cast<float>(in.symmetry()[i]);
  }

  static float end(const Stroke& stroke, float t) {
    const auto to_end = static_cast<float>(stroke.length() - t);
    if (to_end >= stroke.radius_max()) return 0;
    return (stroke.finished() ? 2.0f : 1.0f) * (static_cast<float>(stroke.radius_max()) - to_end);
  }
};

}  // namespace

BURIN_PLUGIN(EveryInput);
