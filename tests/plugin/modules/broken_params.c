/* Lists the brush org.burin.test.broken-params, which claims a parameter and has none. */
#include "c_module.h"

static const char* const no_features[] = {NULL};
static const burin_brush_descriptor broken = {
    .struct_size = sizeof(burin_brush_descriptor),
    .param_count = 1,
    .id = "org.burin.test.broken-params",
    .name = "Broken",
    .vendor = "Burin",
    .version = "1.0.0",
    .features = no_features,
    .inputs_read = BURIN_INPUT_T,
    .outputs_written = BURIN_OUTPUT_DISPLACEMENT,
};
static const burin_brush_descriptor* const brushes[] = {&broken};
static const burin_brush_factory factory = {sizeof(burin_brush_factory), 1, brushes, create_nothing};

static const void* BURIN_CALL get_factory(const char* id) {
  return strcmp(id, BURIN_BRUSH_FACTORY) == 0 ? &factory : NULL;
}

const burin_plugin_entry burin_plugin = {sizeof(burin_plugin_entry),
                                         BURIN_ABI_MAJOR,
                                         BURIN_ABI_MINOR,
                                         0,
                                         init_nothing,
                                         deinit_nothing,
                                         get_factory};
