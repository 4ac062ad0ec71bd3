/* Wants to know all members of the plan of a solid. */
#define IN_PLAN_SOLID \
  if (plan->struct_size > sizeof *plan) plan->detail *= 2
#include "../good.h"
