/* init fails with a text; deinit and get_factory must not be called then. */
#include <burin/abi/plugin.h>
#include <string.h>

static burin_status BURIN_CALL init(const char* plugin_path, burin_text* error) {
  static const char line[] = "no licence";
  (void)plugin_path;
  if (error && BURIN_HAS(error, burin_text, data) && error->capacity >= sizeof line)
    memcpy(error->data, line, sizeof line);
  return BURIN_ERROR;
}

const burin_plugin_entry burin_plugin = {
    sizeof(burin_plugin_entry), BURIN_ABI_MAJOR, BURIN_ABI_MINOR, 0, init, NULL, NULL};
