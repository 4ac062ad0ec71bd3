/* org.example.hello-brush-c. Change what evaluate() writes. */
#include <burin/plugin/c/module.h>
#include <burin/plugin/c/stroke_shape.h>

static const burin_param_info height = {.struct_size = sizeof(burin_param_info),
                                        .type = BURIN_PARAM_FLOAT,
                                        .id = "height",
                                        .name = "Height",
                                        .unit = BURIN_UNIT_RADIUS,
                                        .hard_max = 1,
                                        .soft_max = 1,
                                        .default_number = 0.25f,
                                        .dynamic = 1};
enum { HEIGHT, PARAMS };
static const burin_param_info* const params[] = {&height};
static const char* const features[] = {"procedural", NULL};

static const burin_brush_descriptor descriptor = {
    .struct_size = sizeof(burin_brush_descriptor),
    .param_count = PARAMS,
    .id = "org.example.hello-brush-c",
    .name = "Hello brush c",
    .vendor = "Example",
    .version = "0.1.0",
    .help = "Raises a ridge along the stroke.",
    .features = features,
    .params = params,
    .inputs_read = BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS,
    .outputs_written = BURIN_OUTPUT_DISPLACEMENT,
    .rim_slope = 1.125f}; /* how steeply up rises from the rim: burin_smooth_step(s) <= 9/8 s, height <= 1 */

static void plan(const burin_stroke_context* context, const burin_params* values, burin_stroke_plan* plan) {
  (void)context, (void)values, (void)plan; /* end_influence is for brushes that look at context->length */
}

static burin_status BURIN_CALL evaluate(const burin_brush* brush, void* stroke,
                                        const burin_stroke_context* context, const burin_batch* in,
                                        const burin_outputs* out, burin_text* error) {
  (void)brush, (void)stroke, (void)error;
  const burin_param_value* values = in->params->values;
  for (uint32_t i = 0; i < in->count; ++i) {
    const float t = BURIN_AT(in->t, i), d = BURIN_AT(in->d, i), radius = BURIN_AT(in->radius, i);
    const float share = burin_rim_factor(context, t, d, radius, 1);
    BURIN_AT(out->up, i) = BURIN_AT(values[HEIGHT].number, i) * radius * share;
  }
  return BURIN_OK;
}

BURIN_C_PLUGIN(descriptor, plan, evaluate);
