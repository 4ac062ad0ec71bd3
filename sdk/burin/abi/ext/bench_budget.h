/* burin/abi/ext/bench_budget.h - brush interface: the evaluation time that its author promises, for
 * regression tests. */
#ifndef BURIN_ABI_EXT_BENCH_BUDGET_H
#define BURIN_ABI_EXT_BENCH_BUDGET_H

#include "../brush.h"

#ifdef __cplusplus
extern "C" {
#endif

#define BURIN_EXT_BENCH_BUDGET "burin.bench-budget/1"

/* The interface; burin_brush.get_extension returns it. */
typedef struct burin_bench_budget {
  uint32_t struct_size;
  uint32_t reserved;

  /* Returns the promised time of evaluate with these parameters, as a multiple of the time that copying the
   * inputs that the brush declared takes on the same machine, so that machines can be compared.
   * [any thread, concurrent] */
  double(BURIN_CALL* evaluate_cost)(const burin_brush* brush, const burin_params* params);
} burin_bench_budget;

#ifdef __cplusplus
}
#endif
#endif
