#include "ink/pen_files.h"
#include "support/process.h"

namespace burin {
namespace {

using test::PenFileFolder;
using test::places;

std::string page(const std::string& strokes) {
  return "<?xml version=\"1.0\" standalone=\"no\"?>\n<xournal version=\"0.4.5\">\n<page width=\"595\" "
         "height=\"842\">\n"
         "<layer/>\n<layer>\n" +
         strokes + "</layer>\n</page>\n</xournal>\n";
}

TEST(ReadXournal, HasPositionsAndWidths) {
  const PenFile file = PenFileFolder().read(page(R"(<stroke tool="pen" width="2 1 1.5">1 2
3 4	5 6 </stroke><stroke width="1.41">7 8</stroke><stroke width="2 nan -1">1 1 2 2 3 3</stroke>)"));
  ASSERT_EQ(file.strokes.size(), 3u);
  EXPECT_EQ(places(file.strokes[0]), "1 2, 3 4, 5 6");
  EXPECT_EQ(file.strokes[0].widths, (std::vector<float>{1, 1.5, 1.5})) << "the last point has no segment";
  EXPECT_EQ(file.strokes[0].fields, PenFields()) << "widths are no pressure";
  EXPECT_EQ(file.strokes[0].layer, 2u);
  EXPECT_EQ(file.strokes[1].widths, std::vector<float>{1.41F});
  EXPECT_EQ(file.strokes[2].widths, (std::vector<float>{2, 2, 2})) << "those of a damaged file are unknown";
  EXPECT_EQ(file.unit, "pt");
}

TEST(ReadXournal, TakesTheCommasThatXournalWroteInSomeLanguagesForPoints) {
  const PenFile file = PenFileFolder().read(page(R"(<stroke width="2,5 1,25">1,5 2 -3,25 4</stroke>)"));
  ASSERT_EQ(file.strokes.size(), 1u);
  EXPECT_EQ(places(file.strokes[0]), "1.5 2, -3.25 4");
  EXPECT_EQ(file.strokes[0].widths, (std::vector<float>{1.25, 1.25}));
}

// The form of Xournal++ 1.2 and 1.3: sound, fills, dashes and names of layers, and what is no stroke, whose
// places later versions tell by a matrix.
TEST(ReadXournal, ReadsWhatXournalppWrites) {
  const PenFile file = PenFileFolder().read(
      R"(<?xml version="1.0" standalone="no"?>
<xournal creator="xournalpp 1.3.7" fileversion="5">
<title>Xournal++ document</title>
<preview>iVBORw0KGgo=</preview>
<audio fn="pen.mp3"/>
<page width="595.27559" height="841.88976">
<background type="solid" color="#ffffffff" style="isometric_graph" config="f1=1"/>
<layer name="Drawn">
<timestamp ts="40" fn="pen.mp3"/>
<stroke tool="pen" ts="1000ll" fn="pen.mp3" color="#000000ff" width="2.26 1.13 2.0" capStyle="round">1.5 2 3 4.25 5 6</stroke>
<stroke tool="highlighter" color="#ffff007f" width="8.5" fill="128" style="cust: 6 3" capStyle="butt">7 8 9 10</stroke>
<stroke tool="eraser" color="#ffffffff" width="9" capStyle="square">1e1 -2.5e0 11 12</stroke>
<text font="Sans" size="12" x="74" y="51" color="#000000ff" ts="0ll" fn="" wrap="120" align="center">1 2 &amp; 3</text>
<text font="Sans" size="12" matrix="1 0 0 1 32 31" color="#000000ff">b</text>
<image left="1" top="2" right="3" bottom="4">iVBORw0KGgo=</image>
<image left="1" top="2" right="3" bottom="4"><attachment path="a.png"/></image>
<teximage text="x^2" matrix="1 0 0 1 3 4">JVBERi0=</teximage>
<link align="left" font="Sans" size="12" matrix="1 0 0 1 32 31" url="https://example.org">Link</link>
</layer></page></xournal>
)");
  ASSERT_EQ(file.strokes.size(), 3u);
  EXPECT_EQ(places(file.strokes[0]), "1.5 2, 3 4.25, 5 6");
  EXPECT_EQ(file.strokes[0].widths, (std::vector<float>{1.13F, 2, 2}));
  EXPECT_EQ(places(file.strokes[1]), "7 8, 9 10");
  EXPECT_EQ(places(file.strokes[2]), "10 -2.5, 11 12");
  EXPECT_FALSE(file.strokes[2].drawn_by.eraser) << "white paint";
  EXPECT_EQ(file.not_used, (std::vector<std::string>{"image", "link", "teximage", "text"}));
}

TEST(ReadXournal, UnpacksGzipAndXz) {
  const PenFileFolder folder;
  for (const char* program : {"gzip", "xz"}) {
    const auto path = folder.write("a.xopp", page("<stroke width=\"1\">1 2</stroke>"));
    ASSERT_EQ(test::run_process({program, path.string()}).exit_code, 0);
    const auto packed = path.string() + (program == std::string("gzip") ? ".gz" : ".xz");
    EXPECT_EQ(read_pen_file(packed).strokes.size(), 1u);
    std::string cut = read_file(packed);
    cut.resize(cut.size() - 20);
    EXPECT_NE(folder.complaint(cut), "accepted");
  }
}

TEST(ReadXournal, RefusesWhatUnpacksToTooMuch) {
  const PenFileFolder folder;
  const auto path = folder.write("a.xopp", page(std::string(100'000'000, ' ')));
  ASSERT_EQ(test::run_process({"gzip", path.string()}).exit_code, 0);
  const std::string packed = read_file(path.string() + ".gz");
  EXPECT_EQ(folder.complaint(packed), " unpacks to more than 60 MB");
  std::string noise(20'000'000, ' ');
  unsigned random = 1;
  for (char& c : noise) c = static_cast<char>((random = random * 1664525 + 1013904223) >> 24);
  EXPECT_EQ(folder.complaint(packed + noise), " unpacks to more than 60 MB") << "however large the file is";
}

// A notebook with many pages, as far as it is no more than it can be.
TEST(ReadXournal, ReadsMoreThan60MegabytesThatWereNotMadeToUnpackToMuch) {
  const PenFileFolder folder;
  std::string points;
  for (unsigned i = 0, random = 1; points.size() < 3'100'000; ++i) {
    random = random * 1664525 + 1013904223;
    points +=
        std::to_string(random % 1000) + '.' + std::to_string(random >> 12) + ' ' + std::to_string(i) + ' ';
  }
  std::string strokes;
  for (int i = 0; i < 20; ++i) strokes += "<stroke width=\"1\">" + points + "</stroke>";
  ASSERT_GT(strokes.size(), 60'000'000u);
  const auto path = folder.write("a.xopp", page(strokes));
  ASSERT_EQ(test::run_process({"gzip", "-1", path.string()}).exit_code, 0);
  EXPECT_EQ(read_pen_file(path.string() + ".gz").strokes.size(), 20u);
}

TEST(ReadXournal, NamesTheLineOfAFault) {
  const PenFileFolder folder;
  EXPECT_EQ(folder.complaint(page("\n<stroke width=\"1\">1 2 3</stroke>")),
            "7: a stroke with an x without y");
  EXPECT_EQ(folder.complaint(page("<stroke width=\"1\">1 nan</stroke>")),
            "6: expected a coordinate, found 'nan'");
  EXPECT_EQ(folder.complaint("PK\x03\x04zz").substr(0, 21), " cannot be unpacked: ");
}

}  // namespace
}  // namespace burin
