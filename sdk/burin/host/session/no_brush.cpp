// Implements the functions of the ABI as a brush without effect.
#include <burin/host/session/no_brush.h>

namespace burin {
namespace {

void BURIN_CALL destroy(const burin_brush* /*brush*/) {}

const void* BURIN_CALL get_extension(const burin_brush* /*brush*/, const char* /*id*/) { return nullptr; }

burin_status BURIN_CALL begin(const burin_brush* /*brush*/, const burin_stroke_context* /*context*/,
                              const burin_params* /*params*/, burin_stroke_plan* /*plan*/, void** stroke,
                              burin_text* /*error*/) {
  *stroke = nullptr;
  return BURIN_OK;
}

burin_status BURIN_CALL evaluate(const burin_brush* /*brush*/, void* /*stroke*/,
                                 const burin_stroke_context* /*context*/, const burin_batch* /*batch*/,
                                 const burin_outputs* /*outputs*/, burin_text* /*error*/) {
  return BURIN_OK;
}

void BURIN_CALL end(const burin_brush* /*brush*/, void* /*stroke*/) {}

}  // namespace

const burin_brush& no_brush() {
  static constexpr burin_brush brush{.struct_size = sizeof(burin_brush),
                                     .reserved = 0,
                                     .self = nullptr,
                                     .destroy = destroy,
                                     .get_extension = get_extension,
                                     .begin = begin,
                                     .evaluate = evaluate,
                                     .end = end};
  return brush;
}

const burin_brush_descriptor& no_brush_descriptor() {
  static constexpr const char* features[] = {nullptr};
  static constexpr burin_brush_descriptor descriptor{.struct_size = sizeof(burin_brush_descriptor),
                                                     .param_count = 0,
                                                     .id = "mesh along the stroke",
                                                     .name = "Mesh along the stroke",
                                                     .vendor = "",
                                                     .version = "",
                                                     .help = nullptr,
                                                     .features = features,
                                                     .params = nullptr,
                                                     .inputs_read = 0,
                                                     .outputs_written = 0,
                                                     .overlap = BURIN_OVERLAP_STRONGEST,
                                                     .reserved = 0,
                                                     .rim_slope = 0,
                                                     .reserved2 = 0};
  return descriptor;
}

}  // namespace burin
