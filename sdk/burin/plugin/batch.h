#pragma once
#include <burin/abi/brush.h>
#include <burin/plugin/detail/complete.h>
#include <burin/plugin/detail/error.h>
#include <burin/plugin/detail/param_values.h>
#include <burin/plugin/detail/views.h>
#include <burin/plugin/stroke.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace burin::plugin {

/// The chart nodes to evaluate, one element per node; burin/abi/stroke.h describes each input and its unit.
/// An accessor throws Error unless BrushInfo::inputs declares the input. Call it once per batch, before the
/// loop. Valid during evaluate().
class Batch {
 public:
  Batch(const burin_brush_descriptor& brush, const burin_stroke_context& context, const burin_batch& batch)
      : stroke(context),
        params(brush, complete(batch).params),
        inputs_(brush.inputs_read),
        batch_(complete(batch)) {}
  Batch(const Batch&) = delete;
  Batch& operator=(const Batch&) = delete;

  const Stroke stroke;
  const Params params;

  /// Number of nodes.
  std::size_t size() const { return batch_.count; }

  /// The input of this name, by node; burin_batch tells what it is.
  /// @{
  Floats t() const { return floats(batch_.t, BURIN_INPUT_T, "t"); }
  Floats d() const { return floats(batch_.d, BURIN_INPUT_D, "d"); }
  Floats radius() const { return floats(batch_.radius, BURIN_INPUT_RADIUS, "radius"); }
  Floats stretch() const { return floats(batch_.stretch, BURIN_INPUT_STRETCH, "stretch"); }
  Floats footprint_t() const { return floats(batch_.footprint_t, BURIN_INPUT_FOOTPRINT, "footprint"); }
  Floats footprint_d() const { return floats(batch_.footprint_d, BURIN_INPUT_FOOTPRINT, "footprint"); }
  Vectors position() const { return vectors(batch_.position, BURIN_INPUT_POSITION, "position"); }
  Vectors normal() const { return vectors(batch_.normal, BURIN_INPUT_NORMAL, "normal"); }
  Vectors e1() const { return vectors(batch_.e1, BURIN_INPUT_E1, "e1"); }
  Floats mean_curvature() const {
    return floats(batch_.mean_curvature, BURIN_INPUT_MEAN_CURVATURE, "mean curvature");
  }
  Vectors laplacian() const { return vectors(batch_.laplacian, BURIN_INPUT_LAPLACIAN, "laplacian"); }
  Vectors displacement() const {
    return vectors(batch_.displacement, BURIN_INPUT_DISPLACEMENT, "displacement");
  }
  Floats mask() const { return floats(batch_.mask, BURIN_INPUT_MASK, "mask"); }
  Colours colour() const {
    const auto channel = [&](const burin_floats& values) {
      return floats(values, BURIN_INPUT_COLOUR, "colour");
    };
    const burin_colours& colour = batch_.colour;
    return {channel(colour.r), channel(colour.g), channel(colour.b), channel(colour.a)};
  }
  Indices sheet() const { return indices(batch_.sheet, BURIN_INPUT_SHEET, "sheet"); }
  Indices visit_count() const { return indices(batch_.visit_count, BURIN_INPUT_VISIT_COUNT, "visit count"); }
  Indices node_id() const { return indices(batch_.node_id, BURIN_INPUT_NODE_ID, "node id"); }
  Indices symmetry() const { return indices(batch_.symmetry, BURIN_INPUT_SYMMETRY, "symmetry"); }

  Vectors foot() const { return vectors(batch_.foot, BURIN_INPUT_FOOT, "foot"); }
  Vectors foot_normal() const { return vectors(batch_.foot_normal, BURIN_INPUT_FOOT, "foot"); }

  Vectors fine_position() const {
    return vectors(batch_.fine_position, BURIN_INPUT_FINE_POSITION, "fine position");
  }
  Vectors fine_normal() const { return vectors(batch_.fine_normal, BURIN_INPUT_FINE_NORMAL, "fine normal"); }
  Floats fine_mean_curvature() const {
    return floats(batch_.fine_mean_curvature, BURIN_INPUT_FINE_MEAN_CURVATURE, "fine mean curvature");
  }
  Floats end_distance() const {
    return floats(batch_.end_distance, BURIN_INPUT_END_DISTANCE, "end distance");
  }

  Floats pressure() const { return pen(batch_.pressure, BURIN_INPUT_PRESSURE, "pressure", one_); }
  Floats tilt_x() const { return pen(batch_.tilt_x, BURIN_INPUT_TILT, "tilt", zero_); }
  Floats tilt_y() const { return pen(batch_.tilt_y, BURIN_INPUT_TILT, "tilt", zero_); }
  Floats twist() const { return pen(batch_.twist, BURIN_INPUT_TWIST, "twist", zero_); }
  Floats speed() const { return pen(batch_.speed, BURIN_INPUT_SPEED, "speed", zero_); }
  Floats time() const { return pen(batch_.time, BURIN_INPUT_TIME, "time", zero_); }
  /// @}

 private:
  void require(bool filled, std::uint64_t input, const char* name) const {
    if (!(inputs_ & input))
      throw Error(std::string("the brush reads input '") + name + "' without declaring it",
                  BURIN_INVALID_ARGUMENT);
    if (!filled) throw Error(std::string("this host does not offer input '") + name + "'", BURIN_UNSUPPORTED);
  }
  Floats floats(const burin_floats& values, std::uint64_t input, const char* name) const {
    require(values.data, input, name);
    return {values.data, values.stride};
  }
  Indices indices(const burin_indices& values, std::uint64_t input, const char* name) const {
    require(values.data, input, name);
    return {values.data, values.stride};
  }
  Vectors vectors(const burin_vectors& values, std::uint64_t input, const char* name) const {
    return {floats(values.x, input, name), floats(values.y, input, name), floats(values.z, input, name)};
  }
  /// A pen input, or its neutral value if the host does not know the input.
  Floats pen(const burin_floats& values, std::uint64_t input, const char* name, const float& neutral) const {
    require(true, input, name);
    return values.data ? Floats(values.data, values.stride) : Floats(&neutral, 0);
  }

  const std::uint64_t inputs_;
  const burin_batch batch_;
  const float zero_ = 0, one_ = 1;
};

}  // namespace burin::plugin
