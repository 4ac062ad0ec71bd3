// Checks that docs/stroke_format.md describes what the reader does.
#include <burin/base/file.h>
#include <burin/stroke/stroke_file.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "support/shared_data.h"

namespace burin {
namespace {

std::string page() { return read_file(BURIN_DOCUMENTS "/stroke_format.md"); }

/// The page's examples.
std::vector<std::string> examples() {
  std::vector<std::string> blocks;
  std::istringstream in(page());
  bool inside = false;
  for (std::string line; std::getline(in, line);) {
    if (line == "```jsonl") blocks.emplace_back();
    if (line.starts_with("```"))
      inside = line == "```jsonl";
    else if (inside)
      blocks.back() += line + '\n';
  }
  return blocks;
}

Recording read(const std::string& text) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.path() / "a.stroke") << text;
  return read_strokes(folder.path() / "a.stroke");
}

TEST(StrokeFormatPage, HasExamplesThatAreRead) {
  const std::vector<std::string> blocks = examples();
  ASSERT_EQ(blocks.size(), 2u);
  const Recording in_space = read(blocks[0]), on_screen = read(blocks[1]);
  EXPECT_EQ(in_space.space, StrokeSpace::object);
  ASSERT_EQ(in_space.strokes.size(), 2u);
  EXPECT_EQ(in_space.strokes[0].settings.complete().params.at("depth"), ParamSetting(0.3));
  EXPECT_EQ(in_space.strokes[0].fields, (PenFields{.time = true, .pressure = true}));
  EXPECT_FALSE(in_space.strokes[1].settings.find(&StrokeSettings::brush));
  EXPECT_EQ(in_space.strokes[1].settings.complete().closure, Closure::closed);
  EXPECT_EQ(in_space.strokes[1].fields, PenFields());
  EXPECT_EQ(on_screen.space, StrokeSpace::screen);
  EXPECT_EQ(on_screen.camera->width, 800);
  EXPECT_EQ(on_screen.strokes.at(0).settings.complete().dynamics.at(0).source, PenSource::pressure);
  for (const Recording& recording : {in_space, on_screen}) {
    EXPECT_EQ(recording.cut_off_at, std::nullopt);
    for (const RecordedStroke& stroke : recording.strokes) EXPECT_EQ(stroke.samples.size(), 2u);
  }
}

TEST(StrokeFormatPage, NamesAllSources) {
  std::istringstream names(source_names());
  for (std::string name; std::getline(names >> std::ws, name, ',');)
    EXPECT_NE(page().find("`" + name + "`"), std::string::npos) << name;
}

}  // namespace
}  // namespace burin
