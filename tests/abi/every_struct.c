/* A library in whose debug information libabigail finds every struct of the ABI and all that they lead to. */
#include "layout.h"

#define STRUCT_FUNCTION(type, bytes)  \
  const type* burin_abi_##type(void); \
  const type* burin_abi_##type(void) { return NULL; }
#define NO_MEMBER(type, member, offset)
BURIN_ABI_LAYOUT(STRUCT_FUNCTION, NO_MEMBER)
