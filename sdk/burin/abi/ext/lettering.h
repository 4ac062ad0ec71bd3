/* burin/abi/ext/lettering.h - host service: a line of text as a stamp. */
#ifndef BURIN_ABI_EXT_LETTERING_H
#define BURIN_ABI_EXT_LETTERING_H

#include "stamps.h"

#ifdef __cplusplus
extern "C" {
#endif

#define BURIN_EXT_LETTERING "burin.lettering/1"

/* Measures of a line of text. Lengths are in ems, the size of the font; x runs to the right from the start
 * of the line, y upward from its baseline. The caller sets struct_size; `set` fills the rest. */
typedef struct burin_lettering_info {
  uint32_t struct_size;
  float width;           /* advance width of the line, kerning included: more text would start there */
  float ascent, descent; /* of the font above and below the baseline, both >= 0 */
  float left, right, bottom, top; /* borders of the stamp: u = 0 at left, v = 0 at top */
} burin_lettering_info;

/* The service; burin_host.get_extension returns it. */
typedef struct burin_lettering {
  uint32_t struct_size;
  uint32_t reserved;

  /* Sets a line of UTF-8 text, shaped and kerned by the font's own tables, and opens it as a stamp of one
   * channel: 1 inside letters, 0 outside. `font` is the path of a font file or the file name of a system
   * font ("DejaVuSans.ttf"). `em` is the size of an em in texels, 8 .. 512. The stamp is sampled and closed
   * through burin_stamps; its wrap is BURIN_WRAP_BLACK. A character that the font lacks is an error.
   * [stroke-thread] */
  burin_status(BURIN_CALL* set)(const burin_host* host, const char* font, const char* text, uint32_t em,
                                burin_stamp* stamp, burin_lettering_info* info, burin_text* error);
} burin_lettering;

#ifdef __cplusplus
}
#endif
#endif
