#include <gtest/gtest.h>

#include "host_stub/run_command.h"
#include "support/shapes.h"

namespace burin::test {
namespace {

TEST(RadiusFit, WarnsOfStrokesThatDrawNextToNothing) {
  const CommandFolder folder;
  const std::string mesh = folder.write("sphere.obj", obj_text(sphere(3, 0, 1)));
  const std::string stroke = folder.write(
      "a.stroke", equator_stroke(-0.6, 0.6, 41, "\"brush\":\"org.burin.groove\",\"radius\":0.3"));
  for (const std::string command : {"chart", "replay"}) {
    const auto said = [&](const std::string& radius) {
      std::vector<std::string> arguments = {command, stroke, "--mesh", mesh, "--radius", radius};
      if (command == "replay") arguments.insert(arguments.end(), {"--refine", "off"});
      const ProcessResult result = burin(arguments);
      EXPECT_EQ(result.exit_code, 0);
      return result.err;
    };
    EXPECT_EQ(said("0.3"), "");
    EXPECT_TRUE(
        said("0.001").starts_with("burin: warning: " + mesh +
                                  ": a radius of 0.001 is small against the mean edge, 0.151: little of "
                                  "the stroke meets a vertex\n"));
    EXPECT_EQ(said("1000"),
              "burin: warning: " + mesh +
                  ": a radius of 1e+03 is greater than the whole surface, 3.46: strokes on it are "
                  "too short for it\n");
  }
}

}  // namespace
}  // namespace burin::test
