/* burin/abi/host.h - what a host gives to a plugin. */
#ifndef BURIN_ABI_HOST_H
#define BURIN_ABI_HOST_H

#include "base.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Lives from before a brush is created until after it is destroyed. */
typedef struct burin_host {
  uint32_t struct_size;
  uint32_t abi_major;
  uint32_t abi_minor;
  uint32_t reserved;
  void* self; /* the host's own; a plugin passes the burin_host* and leaves this alone */
  const char* name;
  const char* version;

  /* The host's service with this id ("burin.NAME/1", see ext/), or null where the host withholds it.
   * A service that is returned works whole. The pointer lives as long as the host.
   * [any thread, concurrent, while the host lives] */
  const void*(BURIN_CALL* get_extension)(const struct burin_host* host, const char* id);
} burin_host;

#ifdef __cplusplus
}
#endif
#endif
