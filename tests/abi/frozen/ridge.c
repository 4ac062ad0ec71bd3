/* org.burin.frozen.ridge: a ridge of round section, as a brush of ABI 1.0 was written. README.md tells how
 * ridge.burin is built of it; neither changes any more. */
#include <burin/abi/plugin.h>

static int is(const char* a, const char* b) {
  while (*a && *a == *b) ++a, ++b;
  return *a == *b;
}

static const burin_param_info height = {.struct_size = sizeof(burin_param_info),
                                        .type = BURIN_PARAM_FLOAT,
                                        .id = "height",
                                        .name = "Height",
                                        .unit = BURIN_UNIT_RADIUS,
                                        .hard_min = -1,
                                        .hard_max = 1,
                                        .soft_min = 0,
                                        .soft_max = 1,
                                        .default_number = 0.25f,
                                        .dynamic = 1};
static const burin_param_info* const params[] = {&height};
static const char* const features[] = {"procedural", NULL};
static const burin_brush_descriptor descriptor = {
    .struct_size = sizeof descriptor,
    .param_count = 1,
    .id = "org.burin.frozen.ridge",
    .name = "Frozen ridge",
    .vendor = "Burin",
    .version = "1.0.0",
    .features = features,
    .params = params,
    .inputs_read = BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS | BURIN_INPUT_PRESSURE,
    .outputs_written = BURIN_OUTPUT_DISPLACEMENT};
static const burin_brush_descriptor* const brushes[] = {&descriptor};

static void BURIN_CALL destroy(const burin_brush* brush) { (void)brush; }

static const void* BURIN_CALL get_extension(const burin_brush* brush, const char* id) {
  (void)brush, (void)id;
  return NULL;
}

static burin_status BURIN_CALL begin(const burin_brush* brush, const burin_stroke_context* context,
                                     const burin_params* values, burin_stroke_plan* plan, void** stroke,
                                     burin_text* error) {
  (void)brush, (void)context, (void)values, (void)plan, (void)error;
  *stroke = NULL;
  return BURIN_OK;
}

#define AT(array, i) (array).data[(size_t)(i) * (array).stride]

static burin_status BURIN_CALL evaluate(const burin_brush* brush, void* stroke,
                                        const burin_stroke_context* context, const burin_batch* batch,
                                        const burin_outputs* outputs, burin_text* error) {
  (void)brush, (void)stroke, (void)error;
  for (uint32_t i = 0; i < batch->count; ++i) {
    const float t = AT(batch->t, i), d = AT(batch->d, i), radius = AT(batch->radius, i),
                length = (float)context->length,
                beyond = t < 0        ? -t
                         : t > length ? t - length
                                      : 0,
                rim = 1 - (d * d + beyond * beyond) / (radius * radius);
    if (rim > 0)
      AT(outputs->up, i) =
          AT(batch->params->values[0].number, i) * radius * AT(batch->pressure, i) * rim * rim;
  }
  return BURIN_OK;
}

static void BURIN_CALL end(const burin_brush* brush, void* stroke) { (void)brush, (void)stroke; }

static const burin_brush ridge = {sizeof ridge, 0, NULL, destroy, get_extension, begin, evaluate, end};

static const burin_brush* BURIN_CALL create(const burin_brush_factory* factory, const burin_host* host,
                                            const char* brush_id, burin_text* error) {
  (void)factory, (void)host, (void)error;
  return is(brush_id, descriptor.id) ? &ridge : NULL;
}

static const burin_brush_factory factory = {sizeof factory, 1, brushes, create};

static burin_status BURIN_CALL init(const char* plugin_path, burin_text* error) {
  (void)plugin_path, (void)error;
  return BURIN_OK;
}

static void BURIN_CALL deinit(void) {}

static const void* BURIN_CALL get_factory(const char* factory_id) {
  return is(factory_id, BURIN_BRUSH_FACTORY) ? &factory : NULL;
}

const burin_plugin_entry burin_plugin = {
    sizeof burin_plugin, BURIN_ABI_MAJOR, BURIN_ABI_MINOR, 0, init, deinit, get_factory};
