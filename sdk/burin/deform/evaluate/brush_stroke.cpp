// Calls begin() and end() of a brush, and checks the plan that it returns.
#include <burin/base/error.h>
#include <burin/deform/evaluate/brush_stroke.h>
#include <burin/deform/evaluate/error_text.h>
#include <fmt/format.h>

namespace burin {

BrushStroke::BrushStroke(const burin_brush& brush, const burin_brush_descriptor& descriptor,
                         const burin_stroke_context& context, const burin_params& params)
    : brush_(&brush),
      descriptor_(&descriptor),
      params_(&params),
      plan_{.struct_size = sizeof(burin_stroke_plan), .passes = 1, .end_influence = 0} {
  const PluginCall call("brush", descriptor.id);
  ErrorText error;
  const burin_status status = brush.begin(&brush, &context, &params, &plan_, &stroke_, error.abi());
  if (status != BURIN_OK) throw Error(fmt::format("{}: {}", descriptor.id, error.line(status)));
  // The comparison is also false for NaN.
  if (plan_.passes >= 1 && plan_.end_influence >= 0) return;
  brush.end(&brush, stroke_);
  throw ContractError(fmt::format("{}: asked for {} passes and an end influence of {}", descriptor.id,
                                  plan_.passes, plan_.end_influence));
}

BrushStroke::~BrushStroke() {
  const PluginCall call("brush", descriptor_->id);
  brush_->end(brush_, stroke_);
}

}  // namespace burin
