#include "layout.h"

_Static_assert(sizeof(void*) == 8, "the layout is written down for 8-byte pointers");
#define ASSERT_STRUCT(type, bytes) _Static_assert(sizeof(type) == (bytes), #type);
#define ASSERT_MEMBER(type, member, offset) \
  _Static_assert(offsetof(type, member) == (offset), #type "." #member);
BURIN_ABI_LAYOUT(ASSERT_STRUCT, ASSERT_MEMBER)

const layout_line* burin_layout_in_c(size_t* count) {
#define STRUCT_LINE(type, bytes) {#type, "", sizeof(type)},
#define MEMBER_LINE(type, member, offset) {#type, #member, offsetof(type, member)},
  static const layout_line lines[] = {BURIN_ABI_LAYOUT(STRUCT_LINE, MEMBER_LINE)};
  *count = sizeof lines / sizeof lines[0];
  return lines;
}
