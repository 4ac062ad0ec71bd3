#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/process.h"

namespace burin::kernels {
namespace {

TEST(KernelBench, MeasuresTheSmallestChartAgainstDijkstra) {
  const auto run = test::run_process({BURIN_KERNEL_BENCH, "--benchmark_min_time=0.01",
                                      "--benchmark_filter=^chart/nodes:1000/order:2/threads:1/",
                                      "--benchmark_format=json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto benchmarks = nlohmann::json::parse(run.out).at("benchmarks");
  ASSERT_EQ(benchmarks.size(), 1U);
  const auto figure = [&](const char* name) { return benchmarks[0].at(name).get<double>(); };
  EXPECT_FALSE(benchmarks[0].contains("error_occurred"));
  EXPECT_NEAR(figure("nodes"), 1000, 200);
  EXPECT_NEAR(figure("dijkstra vertices"), figure("nodes"), 0.3 * figure("nodes"));
  EXPECT_GT(figure("ns/node"), 1);
  EXPECT_NEAR(figure("node/dijkstra vertex"), figure("ns/node") / figure("dijkstra ns/vertex"), 1e-6);
  EXPECT_GT(figure("chart/dijkstra"), 0);
}

}  // namespace
}  // namespace burin::kernels
