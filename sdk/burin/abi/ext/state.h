/* burin/abi/ext/state.h - brush ability: state of its own beyond the parameters, kept by the host.
 *
 * Parameters are the host's to keep; this is for what they cannot say. The host writes the bytes into
 * its scene and brings them back later, perhaps to another version of the plugin, perhaps damaged:
 * load treats them as hostile.
 */
#ifndef BURIN_ABI_EXT_STATE_H
#define BURIN_ABI_EXT_STATE_H

#include "../brush.h"

#ifdef __cplusplus
extern "C" {
#endif

#define BURIN_EXT_STATE "burin.state/1"

typedef struct burin_state {
  uint32_t struct_size;
  uint32_t version; /* of the layout that save writes */

  /* Writes the state into data (capacity bytes) and its size into *size. When capacity is too small
   * nothing is written, *size says what is needed, and the call returns BURIN_INVALID_ARGUMENT.
   * [main-thread, no stroke open] */
  burin_status(BURIN_CALL* save)(const burin_brush* brush, void* data, uint64_t capacity, uint64_t* size,
                                 burin_text* error);

  /* Takes a state that save of the given version wrote. On failure the brush is as before.
   * [main-thread, no stroke open] */
  burin_status(BURIN_CALL* load)(const burin_brush* brush, uint32_t version, const void* data, uint64_t size,
                                 burin_text* error);
} burin_state;

#ifdef __cplusplus
}
#endif
#endif
