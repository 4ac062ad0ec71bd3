/* burin/abi/ext/log.h - host service: lines for the host's log. */
#ifndef BURIN_ABI_EXT_LOG_H
#define BURIN_ABI_EXT_LOG_H

#include "../host.h"

#ifdef __cplusplus
extern "C" {
#endif

#define BURIN_EXT_LOG "burin.log/1"

typedef int32_t burin_log_severity;
enum {
  BURIN_LOG_UNKNOWN = 0,
  BURIN_LOG_DEBUG = 1,
  BURIN_LOG_INFO = 2,
  BURIN_LOG_WARNING = 3,
  BURIN_LOG_ERROR = 4
};

/* The service; burin_host.get_extension returns it. */
typedef struct burin_log {
  uint32_t struct_size;
  uint32_t reserved;

  /* Writes one line of UTF-8 text to the log. The line is copied before the call returns. Never fails.
   * [any thread, concurrent] */
  void(BURIN_CALL* write)(const burin_host* host, burin_log_severity severity, const char* line);
} burin_log;

#ifdef __cplusplus
}
#endif
#endif
