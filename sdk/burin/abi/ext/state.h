/* burin/abi/ext/state.h - brush interface: state beyond the parameters, stored by the host.
 *
 * The host stores parameters itself; this interface is for data that parameters cannot express. The host
 * writes the bytes into its scene and passes them back later, perhaps to another version of the plugin,
 * perhaps damaged: load must treat them as untrusted.
 */
#ifndef BURIN_ABI_EXT_STATE_H
#define BURIN_ABI_EXT_STATE_H

#include "../brush.h"

#ifdef __cplusplus
extern "C" {
#endif

#define BURIN_EXT_STATE "burin.state/1"

/* The interface; burin_brush.get_extension returns it. */
typedef struct burin_state {
  uint32_t struct_size;
  uint32_t version; /* of the layout that save writes */

  /* Writes the state into data (capacity bytes) and its size in bytes into *size. If capacity is too small,
   * or data null with a capacity of 0, the call writes only the needed size into *size and returns
   * BURIN_INVALID_ARGUMENT. [main-thread, no stroke open] */
  burin_status(BURIN_CALL* save)(const burin_brush* brush, void* data, uint64_t capacity, uint64_t* size,
                                 burin_text* error);

  /* Restores a state that save of the given version wrote: this one or, if the brush was ever released with
   * it, an older one; of other versions returns BURIN_UNSUPPORTED. data may be null if size is 0. On failure
   * the brush stays as it was. [main-thread, no stroke open] */
  burin_status(BURIN_CALL* load)(const burin_brush* brush, uint32_t version, const void* data, uint64_t size,
                                 burin_text* error);
} burin_state;

#ifdef __cplusplus
}
#endif
#endif
