/* What the plugins of this folder that are written in C have in common: nothing to do in init and deinit. */
#ifndef BURIN_TESTS_C_MODULE_H
#define BURIN_TESTS_C_MODULE_H

#include <burin/abi/plugin.h>
#include <string.h>

static burin_status BURIN_CALL init_nothing(const char* plugin_path, burin_text* error) {
  (void)plugin_path;
  (void)error;
  return BURIN_OK;
}

static void BURIN_CALL deinit_nothing(void) {}

/* A factory's create for brushes that must be refused before anybody creates one. */
static const burin_brush* BURIN_CALL create_nothing(const burin_brush_factory* factory,
                                                    const burin_host* host, const char* brush_id,
                                                    burin_text* error) {
  (void)factory;
  (void)host;
  (void)brush_id;
  (void)error;
  return NULL;
}

#endif
