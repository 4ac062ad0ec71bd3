#include "ink/kinds/bytes.h"
#include "ink/pen_files.h"

namespace burin {
namespace {

using test::Bytes;
using test::PenFileFolder;
using test::places;
using test::riff;
using test::zigzags;

/// A path with its length before it.
std::string path_of(const std::string& points, const std::string& widths) {
  const std::string path =
      Bytes().add_field(3, std::uint64_t{1}).add_field(4, points).add_field(5, widths).text();
  return Bytes().add_varint(path.size()).add_text(path).text();
}

TEST(ReadWill, HasPathsOfARiffAndByThemselves) {
  const std::string paths = path_of(zigzags({10, 20, 5, -10}), zigzags({30})) + path_of(zigzags({1, 2}), "");
  for (const std::string& text : {riff("WILL", "INK ", paths), paths}) {
    const PenFile file = PenFileFolder().read(text);
    EXPECT_EQ(file.kind, "will");
    ASSERT_EQ(file.strokes.size(), 2u);
    EXPECT_EQ(places(file.strokes[0]), "1 2, 1.5 1");
    EXPECT_EQ(file.strokes[0].widths, (std::vector<float>{3, 3})) << "one width is that of all points";
    EXPECT_EQ(file.strokes[0].fields, PenFields());
    EXPECT_TRUE(file.strokes[1].widths.empty());
  }
}

TEST(ReadWill, HasThePathsOfAllMembersOfAZip) {
  const PenFile file = PenFileFolder().read(
      test::stored_zip({{"props/core.xml", "<a/>"},
                        {"sections/media/strokes.protobuf", path_of(zigzags({10, 20}), "")},
                        {"sections/section.svg", "<svg/>"},
                        {"sections/media/strokes1.protobuf",
                         path_of(zigzags({30, 40}), "") + path_of(zigzags({50, 60}), "")}}));
  ASSERT_EQ(file.strokes.size(), 3u);
  EXPECT_EQ(places(file.strokes[0]), "1 2");
  EXPECT_EQ(places(file.strokes[2]), "5 6");
}

TEST(ReadWill, NamesTheByteOfAFault) {
  const PenFileFolder folder;
  EXPECT_EQ(folder.complaint(riff("WILL", "INK ", path_of(zigzags({1, 2, 3}), ""))),
            "byte 21: a path with an x without y");
  EXPECT_EQ(folder.complaint(riff("WILL", "INK ", "\xff\xff\xff\xff\x0f")),
            "byte 25: 4294967295 bytes are told, 0 follow");
}

}  // namespace
}  // namespace burin
