/* A plugin of an ABI that does not exist yet; any call into it is a mistake. */
#include <burin/abi/plugin.h>

const burin_plugin_entry burin_plugin = {sizeof(burin_plugin_entry), 999, 0, 0, NULL, NULL, NULL};
