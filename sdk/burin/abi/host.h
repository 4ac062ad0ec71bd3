/* burin/abi/host.h - the application that runs a plugin, and how the plugin gets its services. */
#ifndef BURIN_ABI_HOST_H
#define BURIN_ABI_HOST_H

#include "base.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The host. It lives from before a brush is created until after it is destroyed. */
typedef struct burin_host {
  uint32_t struct_size;
  uint32_t abi_major;
  uint32_t abi_minor;
  uint32_t reserved;
  void* self; /* for the host's use; a plugin passes the burin_host* and does not touch this */
  const char* name;
  const char* version;

  /* Returns the host's service with this id ("burin.NAME/1", see ext/), or null when the host does not have
   * it. All functions of a returned service work. The pointer lives as long as the host.
   * [any thread, concurrent, while the host lives] */
  const void*(BURIN_CALL* get_extension)(const struct burin_host* host, const char* id);
} burin_host;

#ifdef __cplusplus
}
#endif
#endif
