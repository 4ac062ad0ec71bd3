/* Writes a line without asking whether there is a log. */
#include <burin/abi/ext/log.h>
#define IN_CREATE                                                      \
  const burin_log* service = host->get_extension(host, BURIN_EXT_LOG); \
  service->write(host, BURIN_LOG_INFO, "created")
#include "../good.h"
