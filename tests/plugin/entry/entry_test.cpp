#include <burin/abi/ext/bench_budget.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "plugin/driver.h"

namespace burin {
namespace {

using test::PluginModule;

std::vector<std::string> list(const char* const* texts) {
  std::vector<std::string> found;
  for (; *texts; ++texts) found.emplace_back(*texts);
  return found;
}

TEST(PluginEntry, TellsTheAbiItWasCompiledFor) {
  const PluginModule module("brushes/groove");
  EXPECT_EQ(module.entry().struct_size, sizeof(burin_plugin_entry));
  EXPECT_EQ(module.entry().abi_major, BURIN_ABI_MAJOR);
  EXPECT_EQ(module.entry().abi_minor, BURIN_ABI_MINOR);
}

TEST(PluginEntry, CountsInitAndDeinit) {
  const PluginModule module("brushes/groove");
  const burin_plugin_entry& entry = module.entry();
  const void* factory = entry.get_factory(BURIN_BRUSH_FACTORY);
  ASSERT_TRUE(factory);
  EXPECT_EQ(entry.init("again", nullptr), BURIN_OK);
  entry.deinit();
  EXPECT_EQ(entry.get_factory(BURIN_BRUSH_FACTORY), factory) << "one init is left";
  entry.deinit();
  EXPECT_EQ(entry.get_factory(BURIN_BRUSH_FACTORY), nullptr);
  entry.deinit();
  EXPECT_EQ(entry.init("again", nullptr), BURIN_OK) << "a deinit too many is forgiven";
  EXPECT_EQ(entry.get_factory(BURIN_BRUSH_FACTORY), factory);
}

TEST(PluginEntry, CountsOnManyThreads) {
  const PluginModule module("brushes/groove");
  const burin_plugin_entry& entry = module.entry();
  const auto many = [](const auto& call) {
    std::vector<std::jthread> threads;
    for (int i = 0; i < 4; ++i)
      threads.emplace_back([&] {
        for (int j = 0; j < 5000; ++j) call();
      });
  };
  many([&] { entry.init("path", nullptr); });
  many([&] { entry.deinit(); });
  EXPECT_TRUE(entry.get_factory(BURIN_BRUSH_FACTORY)) << "the module's own init is left";
  entry.deinit();
  EXPECT_FALSE(entry.get_factory(BURIN_BRUSH_FACTORY));
  entry.init("path", nullptr);
}

TEST(PluginEntry, KnowsOneFactory) {
  const PluginModule module("brushes/groove");
  EXPECT_EQ(module.entry().get_factory("burin.other-factory/1"), nullptr);
}

TEST(BrushFactory, RefusesAnUnknownBrush) {
  const PluginModule module("brushes/groove");
  const test::TestHost host;
  char line[100] = "";
  burin_text text{sizeof text, sizeof line, line};
  EXPECT_EQ(module.factory().create(&module.factory(), &host.abi, "org.burin.nothing", &text), nullptr);
  EXPECT_STREQ(line, "this plugin has no brush 'org.burin.nothing'");
}

TEST(BrushFactory, ListsEveryBrushOfTheModule) {
  const PluginModule module("test-brushes/probes");
  ASSERT_EQ(module.factory().brush_count, 2u);
  EXPECT_STREQ(module.factory().brushes[0]->id, "org.burin.test.params");
  EXPECT_STREQ(module.factory().brushes[1]->id, "org.burin.test.start");
  const test::TestHost host;
  EXPECT_EQ(test::StrokeDriver(module, "org.burin.test.start", host.abi).begin().status, BURIN_OK);
}

TEST(BrushDescriptor, SaysWhatTheBrushDeclares) {
  const PluginModule module("test-brushes/probes");
  const burin_brush_descriptor& brush = module.descriptor("org.burin.test.params");
  EXPECT_EQ(brush.struct_size, sizeof brush);
  EXPECT_STREQ(brush.name, "Parameters");
  EXPECT_STREQ(brush.vendor, "Burin");
  EXPECT_STREQ(brush.version, "1.0.0");
  EXPECT_STREQ(brush.help, "Writes its parameters.");
  EXPECT_EQ(list(brush.features), (std::vector<std::string>{"probe", "test"}));
  EXPECT_EQ(brush.inputs_read, BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS);
  EXPECT_EQ(brush.outputs_written, BURIN_OUTPUT_DISPLACEMENT | BURIN_OUTPUT_MASK | BURIN_OUTPUT_COLOUR);
  EXPECT_EQ(brush.param_count, 8u);
}

TEST(BrushDescriptor, NeedsNeitherParametersNorFeatures) {
  const PluginModule module("test-brushes/probes");
  const burin_brush_descriptor& brush = module.descriptor("org.burin.test.start");
  EXPECT_EQ(brush.param_count, 0u);
  EXPECT_TRUE(list(brush.features).empty());
  EXPECT_EQ(brush.help, nullptr);
}

/// What the only brush of a module promises of its time, or nothing.
std::optional<double> promised_budget(const PluginModule& module) {
  const test::TestHost host;
  const burin_brush_factory& factory = module.factory();
  const burin_brush* brush = factory.create(&factory, &host.abi, factory.brushes[0]->id, nullptr);
  std::optional<double> cost;
  const auto* budget =
      static_cast<const burin_bench_budget*>(brush->get_extension(brush, BURIN_EXT_BENCH_BUDGET));
  if (budget) cost = budget->evaluate_cost(brush, nullptr);
  brush->destroy(brush);
  return cost;
}

TEST(BrushInfo, PromisesABudgetWhereItStatesOne) {
  EXPECT_EQ(promised_budget(PluginModule("brushes/groove")), 100);
  EXPECT_EQ(promised_budget(PluginModule("brushes/bead")), std::nullopt);
}

TEST(StockBrushes, DeclareTheParametersThatStrokesName) {
  const auto ids = [](const burin_brush_descriptor& brush) {
    std::vector<std::string> found;
    for (std::uint32_t i = 0; i < brush.param_count; ++i) found.emplace_back(brush.params[i]->id);
    return found;
  };
  const PluginModule groove("brushes/groove"), scales("brushes/scales");
  EXPECT_EQ(ids(groove.descriptor("org.burin.groove")),
            (std::vector<std::string>{"depth", "width", "taper", "profile"}));
  EXPECT_EQ(ids(scales.descriptor("org.burin.scales")),
            (std::vector<std::string>{"stamp", "depth", "centre", "tile", "aspect", "fade", "offset_along",
                                      "offset_across", "mirror", "flip", "clean", "layer", "channel"}));
}

TEST(StrokeStart, TellsTheModulesPathAndTakesThePlan) {
  const PluginModule module("test-brushes/probes");
  test::TestHost host;
  test::StrokeDriver stroke(module, "org.burin.test.start", host.abi);
  stroke.context.radius_max = 4;
  ASSERT_EQ(stroke.begin().status, BURIN_OK);
  ASSERT_EQ(host.lines.size(), 1u);
  EXPECT_EQ(host.lines[0], std::pair(burin_log_severity{BURIN_LOG_INFO}, module.path));
  EXPECT_EQ(stroke.plan.passes, 3u);
  EXPECT_EQ(stroke.plan.end_influence, 8);
  stroke.context.pass = 2;
  ASSERT_EQ(stroke.evaluate({{1}, {0}}).status, BURIN_OK);
  EXPECT_EQ(stroke.up[0], 2);
}

TEST(Begin, RefusesValuesOutsideOfTheirRanges) {
  const PluginModule groove("brushes/groove"), text("brushes/text");
  const test::TestHost host;
  const auto begin = [&](const PluginModule& module, const char* brush, const char* param, float value) {
    test::StrokeDriver stroke(module, brush, host.abi);
    stroke.params.set(param, value);
    return stroke.begin();
  };
  constexpr float infinity = std::numeric_limits<float>::infinity(), nan = std::nanf("");
  for (const float value : {-0.1f, nan, infinity, -infinity}) {
    const test::Answer answer = begin(groove, "org.burin.groove", "width", value);
    EXPECT_EQ(answer.status, BURIN_INVALID_ARGUMENT) << value;
    EXPECT_EQ(answer.text, "a value is outside of its range: width");
  }
  for (const float value : {-1.0f, 1000.0f})
    EXPECT_EQ(begin(groove, "org.burin.groove", "profile", value).text,
              "a value is outside of its range: profile");
  const std::vector<float> colour = {0.5f, 0.5f, nan, 1};
  test::StrokeDriver stroke(text, "org.burin.text", host.abi);
  for (std::size_t k = 0; k < 4; ++k) stroke.params.value("colour").colour[k] = {&colour[k], 0, 0};
  EXPECT_EQ(stroke.begin().text, "a value is outside of its range: colour");
  EXPECT_EQ(begin(groove, "org.burin.groove", "width", 1).status, BURIN_OK);
}

TEST(Stroke, HasAnObjectOfItsOwnFromBeginToEnd) {
  const PluginModule module("test-brushes/probes");
  test::TestHost host;
  test::StrokeDriver stroke(module, "org.burin.test.start", host.abi);
  ASSERT_EQ(stroke.begin().status, BURIN_OK);
  ASSERT_EQ(stroke.evaluate({{1}, {0}}).status, BURIN_OK);
  EXPECT_EQ(host.lines.size(), 1u);
  stroke.end();
  ASSERT_EQ(host.lines.size(), 2u);
  EXPECT_EQ(host.lines[1], std::pair(burin_log_severity{BURIN_LOG_DEBUG}, std::string("end")));
}

TEST(TwoModules, KeepApartClassesOfOneName) {
  const PluginModule a("test-brushes/twin_a"), b("test-brushes/twin_b");
  const test::TestHost host;
  test::StrokeDriver in_a(a, "org.burin.test.twin-a", host.abi), in_b(b, "org.burin.test.twin-b", host.abi);
  for (test::StrokeDriver* stroke : {&in_a, &in_b}) {
    ASSERT_EQ(stroke->begin().status, BURIN_OK);
    ASSERT_EQ(stroke->evaluate({{1}, {0}}).status, BURIN_OK);
  }
  EXPECT_EQ(in_a.up[0], 1.25f);
  EXPECT_EQ(in_b.up[0], 2.75f);
}

}  // namespace
}  // namespace burin
