#pragma once
#include <burin/abi/brush.h>
#include <burin/deform/evaluate/plugin_call.h>

namespace burin {

/// A stroke of a brush between the ABI's begin() and end(). Brush, descriptor and parameters must outlive the
/// object.
class BrushStroke {
 public:
  /// Starts the stroke. Throws Error "ID: ..." if the brush refuses, ContractError if its plan is invalid.
  BrushStroke(const burin_brush& brush, const burin_brush_descriptor& descriptor,
              const burin_stroke_context& context, const burin_params& params);
  ~BrushStroke();
  BrushStroke(const BrushStroke&) = delete;
  BrushStroke& operator=(const BrushStroke&) = delete;

  const burin_brush_descriptor& descriptor() const { return *descriptor_; }
  const burin_params& params() const { return *params_; }
  const burin_stroke_plan& plan() const { return plan_; }

  /// An optional ability of the brush; null: it has none of this id. Its functions take brush() and handle().
  const void* extension(const char* id) const {
    const PluginCall call("brush", descriptor_->id);
    return brush_->get_extension(brush_, id);
  }
  const burin_brush* brush() const { return brush_; }
  void* handle() const { return stroke_; }

  /// May be called from several threads at once.
  burin_status evaluate(const burin_stroke_context& context, const burin_batch& batch,
                        const burin_outputs& outputs, burin_text* error) const {
    const PluginCall call("brush", descriptor_->id);
    return brush_->evaluate(brush_, stroke_, &context, &batch, &outputs, error);
  }

 private:
  const burin_brush* brush_;
  const burin_brush_descriptor* descriptor_;
  const burin_params* params_;
  burin_stroke_plan plan_;
  void* stroke_ = nullptr;
};

}  // namespace burin
