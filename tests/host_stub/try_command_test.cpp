#include <burin/base/file.h>
#include <gtest/gtest.h>

#include "run_command.h"

namespace burin::test {
namespace {

const std::string groove = std::filesystem::path(BURIN_COMMAND).parent_path() / "brushes" / "groove.burin";

TEST(TryCommand, DrawsAModuleAsTheBrushOfItsName) {
  const CommandFolder folder;
  const std::string of_module = folder.path("module.png"), of_id = folder.path("id.png");
  const std::string text = burin_output({"try", groove, "--png", of_module});
  EXPECT_EQ(text.find("org.burin.groove: 61 events, "), 0u) << text;
  burin_output({"try", "org.burin.groove", "--png", of_id});
  EXPECT_EQ(read_file(of_module), read_file(of_id));
}

TEST(TryCommand, ShowsWhatParametersChange) {
  const CommandFolder folder;
  const std::string plain = folder.path("plain.png"), deep = folder.path("deep.png");
  burin_output({"try", groove, "--png", plain});
  burin_output({"try", groove, "--param", "depth=0.8", "--param", "profile=v", "--png", deep});
  EXPECT_NE(read_file(plain), read_file(deep));
}

TEST(TryCommand, DrawsSoftHillsWhereTheUserChoseNoFile) {
  const CommandFolder folder;
  const ProcessResult result = burin({"try", "org.burin.scales", "--png", folder.path("a.png")});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "burin: warning: no --param stamp=FILE was given: it is an image of soft hills\n");
}

TEST(TryCommand, ShowsTheSolidThatIsAskedFor) {
  const CommandFolder folder;
  const auto picture = [&](const std::vector<std::string>& options) {
    std::vector<std::string> command = {"try", "org.burin.tube", "--png", folder.path("a.png")};
    command.insert(command.end(), options.begin(), options.end());
    burin_output(command);
    return read_file(folder.path("a.png"));
  };
  const std::string fine = picture({});
  EXPECT_NE(picture({"--solid", "none"}), fine);
  EXPECT_NE(picture({"--voxel", "0.05"}), fine) << "coarse voxels";
  const std::string refused = burin({"try", "org.burin.tube", "--solid", "glow"}).err;
  EXPECT_EQ(refused, burin({"replay", "a.stroke", "--mesh", "a.obj", "--solid", "glow"}).err);
}

TEST(TryCommand, NamesWhatIsNoBrush) {
  const CommandFolder folder;
  const std::string module =
      folder.write("a.burin", "This is a text and not a shared module, whatever its name says.\n");
  const ProcessResult result = burin({"try", module, "--png", folder.path("a.png")});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.err, "burin: " + module + ": invalid ELF header\n");
  EXPECT_FALSE(std::filesystem::exists(folder.path("a.png")));
}

}  // namespace
}  // namespace burin::test
