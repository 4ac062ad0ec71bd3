/* burin/abi/ext/bench_budget.h - brush ability: the time its author promises, for regression runs. */
#ifndef BURIN_ABI_EXT_BENCH_BUDGET_H
#define BURIN_ABI_EXT_BENCH_BUDGET_H

#include "../brush.h"

#ifdef __cplusplus
extern "C" {
#endif

#define BURIN_EXT_BENCH_BUDGET "burin.bench-budget/1"

typedef struct burin_bench_budget {
  uint32_t struct_size;
  uint32_t reserved;

  /* Promised time of evaluate with these parameters, in multiples of the time that copying the batch's
   * inputs and outputs takes on the same machine: a figure that travels between machines.
   * [any thread, concurrent] */
  double(BURIN_CALL* evaluate_cost)(const burin_brush* brush, const burin_params* params);
} burin_bench_budget;

#ifdef __cplusplus
}
#endif
#endif
