/* Does nothing, and promises to need less than 12.5 copies for it. */
#define BURIN_C_BUDGET 12.5
#include <burin/plugin/c/module.h>

static const char* const features[] = {NULL};
static const burin_brush_descriptor descriptor = {.struct_size = sizeof(burin_brush_descriptor),
                                                  .id = "org.example.budget-in-c",
                                                  .name = "Budget in C",
                                                  .vendor = "Example",
                                                  .version = "1.0.0",
                                                  .features = features,
                                                  .inputs_read = BURIN_INPUT_T,
                                                  .outputs_written = BURIN_OUTPUT_DISPLACEMENT};

static void plan(const burin_stroke_context* context, const burin_params* params, burin_stroke_plan* plan) {
  (void)context, (void)params, (void)plan;
}

static burin_status BURIN_CALL evaluate(const burin_brush* brush, void* stroke,
                                        const burin_stroke_context* context, const burin_batch* in,
                                        const burin_outputs* out, burin_text* error) {
  (void)brush, (void)stroke, (void)context, (void)in, (void)out, (void)error;
  return BURIN_OK;
}

BURIN_C_PLUGIN(descriptor, plan, evaluate);
