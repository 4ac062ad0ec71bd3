#include <numbers>

#include "ink/kinds/bytes.h"
#include "ink/pen_files.h"

namespace burin {
namespace {

using test::Bytes;
using test::PenFileFolder;
using test::places;

std::string with_length(std::string_view content) {
  return Bytes().add_varint(content.size()).add_text(content).text();
}

std::string stream_of(const std::string& tags) { return std::string(1, '\0') + with_length(tags); }

/// Two points with pressure, in arrays of 8 and 9 bits: 10 20, 30 -40, 51 255 of 255.
std::string ink() {
  constexpr char descriptor = 5, metrics = 25, scale = 17, stroke = 10, pressure = 56;
  Bytes bytes;
  bytes.add(descriptor).add_text(with_length(std::string(1, pressure)));
  bytes.add(metrics).add_text(
      with_length(pressure + with_length(Bytes().add_varint(0).add_varint(510).text())));
  bytes.add(scale).add(100.F);
  bytes.add(stroke).add_text(
      with_length("\x02" + std::string("\x08\x0a\x14\x08\x1e\xd8\x09\x19\xbf\xc0", 10)));
  return stream_of(bytes.text());
}

std::string gif_of(const std::string& comment) {
  return std::string("GIF89a\1\0\1\0\0\0\0", 13) + "\x21\xFE" + with_length(comment) + std::string(1, '\0') +
         ";";
}

TEST(ReadIsf, HasTheSameInEachWrapping) {
  for (const std::string& text : {ink(), ink() + "an older, longer file", gif_of(ink())}) {
    const PenFile file = PenFileFolder().read(text);
    EXPECT_EQ(file.kind, "isf");
    ASSERT_EQ(file.strokes.size(), 1u);
    EXPECT_EQ(places(file.strokes[0]), "10 30, 20 -40");
    EXPECT_EQ(file.strokes[0].fields, PenFields{.pressure = true});
    EXPECT_FLOAT_EQ(file.strokes[0].samples[0].pen.pressure, 51 / 255.F);
    EXPECT_EQ(file.strokes[0].samples[1].pen.pressure, 1.F);
  }
  EXPECT_EQ(PenFileFolder().read("base64:AAcKBQEICggU").strokes.size(), 1u);
}

/// A stroke of three points 0 0, 1 1, 2 2 whose descriptor is this, and what follows its x and y.
std::string three_points(const std::string& guids, const std::string& descriptor, const std::string& behind) {
  constexpr char guid_table = 1, descriptor_block = 5, stroke = 10;
  Bytes bytes;
  if (!guids.empty()) bytes.add(guid_table).add_text(with_length(guids));
  bytes.add(descriptor_block).add_text(with_length(descriptor));
  bytes.add(stroke).add_text(with_length(std::string("\3\x08\0\1\2\x08\0\1\2", 9) + behind));
  return stream_of(bytes.text());
}

TEST(ReadIsf, TellsOfTheButtonAtThePensSide) {
  // The tags of the buttons: of the tip, 83, and of the pen's side, 85 or what the table of GUIDs gives.
  const std::string barrel = "\x28\x03\x72\xf0\x3b\x66\x8f\x41\x85\xa6\x95\x31\xae\x3e\xcd\xfa";
  const std::string others(16, 'x');
  for (const auto& [guids, tags] :
       std::vector<std::pair<std::string, std::string>>{{"", "\x53\x55"}, {others + barrel, "\x53\x65"}}) {
    // Two bits a point, of which the second is the tip: 01, 11, 01.
    const PenFile file = PenFileFolder().read(three_points(guids, "\6\2" + tags, "\x74"));
    ASSERT_EQ(file.strokes.size(), 1u);
    EXPECT_EQ(file.strokes[0].fields, PenFields{.barrel = true});
    EXPECT_FALSE(file.strokes[0].samples.at(0).barrel);
    EXPECT_TRUE(file.strokes[0].samples.at(1).barrel);
    EXPECT_FALSE(file.strokes[0].samples.at(2).barrel);
  }
  const PenFile without = PenFileFolder().read(three_points("", "\6\1\x53", "\xe0"));
  EXPECT_FALSE(without.strokes.at(0).fields.barrel) << "of the tip only";
  const PenFile absent = PenFileFolder().read(three_points("", "\6\1\x55", ""));
  EXPECT_FALSE(absent.strokes.at(0).fields.barrel) << "told, but not there";
  EXPECT_EQ(PenFileFolder().complaint(three_points("", "\6\7\x55", "")).substr(0, 5), "byte ");
}

TEST(ReadIsf, TellsTheEraserOfAPenThatIsInverted) {
  for (const char status : {'\0', '\1', '\2', '\3'}) {
    const PenFile file =
        PenFileFolder().read(three_points("", "\x35", std::string("\x08\0", 2) + status + '\0'));
    EXPECT_EQ(file.strokes.at(0).drawn_by.eraser, status >= 2) << int{status};
  }
}

TEST(ReadIsf, TakesTheTiltOfPensWhoseMetricsAreTheUsualOnes) {
  // Tilts of 10, 0, 0 and 0, -20, 0 tenths of a degree.
  const std::string tilts("\x08\x0a\0\0\x08\0\xec\0", 8), twists("\x08\x14\0\0", 4);
  const PenFile file = PenFileFolder().read(three_points("", "\x3b\x3c\x3f", tilts + twists));
  ASSERT_TRUE(file.strokes.at(0).fields.tilt);
  constexpr float degree = static_cast<float>(std::numbers::pi / 180);
  EXPECT_FLOAT_EQ(file.strokes[0].samples.at(0).pen.tilt_x, degree);
  EXPECT_FLOAT_EQ(file.strokes[0].samples.at(1).pen.tilt_y, -2 * degree);
  EXPECT_TRUE(file.strokes[0].fields.twist);
  EXPECT_FLOAT_EQ(file.strokes[0].samples[0].pen.twist, 2 * degree);
}

TEST(ReadIsf, TakesTiltsAboveAHalfTurnForThoseToTheOtherSide) {
  // 16 bits each: 3500 and 100 tenths of a degree.
  const std::string tilts("\x10\x0d\xac\0\x64\0\0\x10\0\0\0\0\0\0", 14);
  const PenFile file = PenFileFolder().read(three_points("", "\x3b\x3c", tilts));
  EXPECT_NEAR(file.strokes.at(0).samples.at(0).pen.tilt_x, -std::numbers::pi / 18, 1e-6);
  EXPECT_NEAR(file.strokes[0].samples.at(1).pen.tilt_x, std::numbers::pi / 18, 1e-6);
}

TEST(ReadIsf, PassesOverPropertiesOfTheFile) {
  constexpr char stroke = 10, time_stamp = 78, of_guid = 100;
  // A known property has no length; another has that of its data without the byte that tells the packing.
  Bytes bytes;
  bytes.add(time_stamp).add_text(std::string(16, '\x7f')).add(of_guid).add_text(with_length("abc")).add('\0');
  bytes.add(stroke).add_text(with_length(std::string("\2\x08\1\2\x08\0\3", 7)));
  const PenFile file = PenFileFolder().read(stream_of(bytes.text()));
  ASSERT_EQ(file.strokes.size(), 1u);
  EXPECT_EQ(places(file.strokes[0]), "0.01 0, 0.02 0.03");
}

TEST(ReadIsf, PlacesPointsByTheLastTransform) {
  constexpr char transform = 16, scale = 17, stroke = 10;
  Bytes bytes;
  bytes.add(scale).add(7.F);
  // What x gives to x and y, what y gives to x and y, and what is added, 0.01 mm.
  for (bytes.add(transform); const float one : {0.F, 100.F, -200.F, 0.F, 300.F, 400.F}) bytes.add(one);
  bytes.add(stroke).add_text(with_length(std::string("\2\x08\1\2\x08\0\3", 7)));
  const PenFile file = PenFileFolder().read(stream_of(bytes.text()));
  ASSERT_EQ(file.strokes.size(), 1u);
  EXPECT_EQ(places(file.strokes[0]), "3 5, -3 6");
}

TEST(ReadIsf, NamesTheByteOfAFault) {
  const PenFileFolder folder;
  EXPECT_EQ(folder.complaint(stream_of("\x0a" + with_length("\xff\xff\xff\xff\x07"))),
            "byte 9: more points are told than bytes can hold");
  const std::string more = Bytes().add_varint((1U << 20) + 1).add_text(std::string(1U << 18, '\0')).text();
  EXPECT_EQ(folder.complaint(stream_of("\x0a" + with_length(more))),
            "byte 11: a file of more than 1048576 points");
  EXPECT_EQ(folder.complaint("GIF89a" + std::string(7, '\0') + ";"),
            " a GIF without a comment, which would have the strokes");
  EXPECT_EQ(folder.complaint("base64:?"), " a letter that is none of base64");
}

}  // namespace
}  // namespace burin
