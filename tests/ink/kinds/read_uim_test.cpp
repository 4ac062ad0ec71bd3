#include <cmath>

#include "ink/kinds/bytes.h"
#include "ink/pen_files.h"

namespace burin {
namespace {

using test::Bytes;
using test::PenFileFolder;
using test::places;
using test::riff;
using test::zigzags;

std::string channel(const char* id, const char* type, double resolution, std::uint64_t precision) {
  return Bytes()
      .add_field(1, id)
      .add_field(2, std::string("will://input/3.0/channel/") + type)
      .add_field(4, resolution)
      .add_field(7, precision)
      .text();
}

std::string numbers(const char* id, std::initializer_list<std::int64_t> values) {
  return Bytes().add_field(1, id).add_field(2, zigzags(values)).text();
}

/// Sensors of a pen with a clock, and of a microphone with another.
std::string contexts() {
  const std::string pen = Bytes()
                              .add_field(2, channel("x", "X", 96 / 0.0254, 1))
                              .add_field(2, channel("y", "Y", 96 / 0.0254, 1))
                              .add_field(2, channel("t", "Timestamp", 1000, 0))
                              .add_field(2, channel("p", "Pressure", 1, 2))
                              .add_field(5, "pen")
                              .text();
  const std::string microphone = Bytes().add_field(2, channel("u", "Timestamp", 1000, 0)).text();
  const std::string context = Bytes().add_field(2, pen).add_field(2, microphone).text();
  return Bytes()
      .add_field(2, Bytes().add_field(1, "pen").add_field(2, std::uint64_t{2}).text())
      .add_field(5, context)
      .text();
}

std::string data(std::uint64_t state, std::initializer_list<std::int64_t> x,
                 std::initializer_list<std::int64_t> y) {
  return Bytes()
      .add_field(3, state)
      .add_field(4, std::uint64_t{1600000000500})
      .add_field(5, numbers("u", {7}))
      .add_field(5, numbers("x", x))
      .add_field(5, numbers("y", y))
      .add_field(5, numbers("t", {0, 8}))
      .add_field(5, numbers("p", {50, -25}))
      .text();
}

std::string input(const std::string& sensor_data) {
  return Bytes().add_field(1, contexts()).add_field(2, sensor_data).text();
}

TEST(ReadUim, HasWhatTheSensorsMeasured) {
  const std::string message = input(data(0, {10, 20}, {30, -5}));
  for (const std::string& text :
       {riff("UINK", "INPT", message), riff("UINK", "DATA", Bytes().add_field(1, message).text())}) {
    const PenFile file = PenFileFolder().read(text);
    EXPECT_EQ(file.kind, "uim");
    ASSERT_EQ(file.strokes.size(), 1u);
    const PenStroke& stroke = file.strokes[0];
    EXPECT_EQ(places(stroke), "1 3, 3 2.5");
    EXPECT_EQ(stroke.fields, (PenFields{.time = true, .pressure = true}));
    EXPECT_EQ(stroke.drawn_by.tool, "mouse");
    EXPECT_DOUBLE_EQ(stroke.samples[1].time, 1600000000.508);
    EXPECT_EQ(stroke.samples[1].pen.pressure, 0.25F);
  }
}

TEST(ReadUim, TellsOfSplinesThatNoSensorMeasured) {
  const std::string spline = Bytes().add_field(1, Bytes().add_field(1, "stroke").text()).text();
  for (const std::string& text :
       {riff("UINK", "INKD", spline), riff("UINK", "DATA", Bytes().add_field(2, spline).text())}) {
    const PenFile file = PenFileFolder().read(text);
    EXPECT_TRUE(file.strokes.empty());
    EXPECT_EQ(file.not_used, std::vector<std::string>{"splines without sensor data"});
  }
}

TEST(ReadUim, LeavesHoveringOut) {
  const PenFile file = PenFileFolder().read(riff("UINK", "INPT", input(data(1, {10, 20}, {30, -5}))));
  EXPECT_TRUE(file.strokes.empty());
  EXPECT_EQ(file.hovering, 2u);
}

// A file may hold what an accelerometer measured.
TEST(ReadUim, PassesOverDataWithoutPositions) {
  const std::string other = Bytes().add_field(5, numbers("u", {7})).text();
  const std::string message =
      Bytes().add_field(1, contexts()).add_field(2, other).add_field(2, data(0, {1}, {2})).text();
  EXPECT_EQ(PenFileFolder().read(riff("UINK", "INPT", message)).strokes.size(), 1u);
}

TEST(ReadUim, ScalesPressuresAboveOneByTheGreatest) {
  const std::string pressure =
      Bytes().add_field(1, "p").add_field(2, "will://input/3.0/channel/Pressure").add_field(6, 1024.F).text();
  const std::string group = Bytes()
                                .add_field(2, channel("x", "X", 0, 0))
                                .add_field(2, channel("y", "Y", 0, 0))
                                .add_field(2, pressure)
                                .text();
  const std::string described = Bytes().add_field(5, Bytes().add_field(2, group).text()).text();
  const auto pressure_of = [&](std::int64_t first) {
    const std::string measured = Bytes()
                                     .add_field(5, numbers("x", {1, 1}))
                                     .add_field(5, numbers("y", {1, 1}))
                                     .add_field(5, numbers("p", {first, 0}))
                                     .text();
    return PenFileFolder()
        .read(riff("UINK", "INPT", Bytes().add_field(1, described).add_field(2, measured).text()))
        .strokes.at(0)
        .samples.at(1)
        .pen.pressure;
  };
  EXPECT_EQ(pressure_of(256), 0.25F);
  EXPECT_EQ(pressure_of(1), 1) << "declared ranges are wrong sometimes";
}

TEST(ReadUim, HasTheTwistOfPensThatMeasureIt) {
  const std::string group = Bytes()
                                .add_field(2, channel("x", "X", 0, 0))
                                .add_field(2, channel("y", "Y", 0, 0))
                                .add_field(2, channel("r", "Rotation", 1, 2))
                                .text();
  const std::string described = Bytes().add_field(5, Bytes().add_field(2, group).text()).text();
  for (const std::int64_t turn : {0, 50}) {
    const std::string measured = Bytes()
                                     .add_field(5, numbers("x", {1, 1}))
                                     .add_field(5, numbers("y", {1, 1}))
                                     .add_field(5, numbers("r", {0, turn}))
                                     .text();
    const PenFile file = PenFileFolder().read(
        riff("UINK", "INPT", Bytes().add_field(1, described).add_field(2, measured).text()));
    EXPECT_EQ(file.strokes.at(0).fields.twist, turn != 0);
    EXPECT_EQ(file.strokes[0].samples.at(1).pen.twist, turn == 0 ? 0 : 0.5F);
  }
}

TEST(ReadUim, NamesTheByteOfAFault) {
  const PenFileFolder folder;
  const auto complaint = [&](const std::string& message) {
    return folder.complaint(riff("UINK", "INPT", message));
  };
  EXPECT_NE(complaint(input(data(0, {10, 20}, {30}))).find("X and Y differ in their counts"),
            std::string::npos);
  EXPECT_EQ(complaint("\x0a\x7f"), "byte 22: 127 bytes are told, 0 follow");
  EXPECT_EQ(complaint("\x0f"), "byte 21: no field of a message");
  EXPECT_EQ(folder.complaint(Bytes().add_text("RIFFxxxxUINKINPT").add(0x80000000U).text()),
            "byte 20: 2147483648 bytes are told, 0 follow");
  // The second chunk behind the head is compressed.
  const std::string head("HEAD\x14\0\0\0\3\1\0\0\3\1\0\1\0\0\0\0\3\1\0\1\1\0\0\0", 28);
  EXPECT_EQ(folder.complaint(
                Bytes().add_text("RIFFxxxxUINK" + head + "PRPS").add(0U).add_text("INPT").add(0U).text()),
            "byte 56: the chunk 'INPT' is compressed, which is not read");
}

TEST(ReadUimJson, NamesThePlaceOfAFault) {
  EXPECT_EQ(
      PenFileFolder().complaint(
          R"({"inputData": {"inputContextData": {}, "sensorData": [{"dataChannels": [{"sensorChannelID": }]}]}})"),
      "1: malformed JSON at column 93");
}

TEST(ReadUimJson, TellsTheTool) {
  const auto tool = [](const std::string& provider) {
    return PenFileFolder()
        .read(
            R"({"inputData": {"inputContextData": {"inkInputProviders": [{"id": "a")" + provider +
            R"(}], "sensorContexts": [{"sensorChannelsContext": [{"inkInputProviderID": "a", "channels": [)"
            R"({"id": "x", "type": "a/X"}, {"id": "y", "type": "a/Y"}]}]}]}, "sensorData": [{"dataChannels": [)"
            R"({"sensorChannelID": "x", "values": [1]}, {"sensorChannelID": "y", "values": [2]}]}]}})")
        .strokes.at(0)
        .drawn_by.tool;
  };
  EXPECT_EQ(tool(""), "pen");
  EXPECT_EQ(tool(R"(, "type": "MOUSE")"), "mouse");
  EXPECT_EQ(tool(R"(, "type": "ELBOW")"), "");
}

TEST(ReadUimJson, HasTheSame) {
  const PenFile file = PenFileFolder().read(R"({"inputData": {"inputContextData": {"sensorContexts": [
    {"sensorChannelsContext": [{"channels": [{"id": "x", "type": "a/X", "precision": 1}, {"id": "y", "type": "a/Y"},
    {"id": "t", "type": "a/Timestamp", "resolution": 1000}, {"id": "l", "type": "a/Altitude", "precision": 2},
    {"id": "z", "type": "a/Azimuth"}]}]}]}, "sensorData": [{"timestamp": "1600000000500", "dataChannels": [
    {"sensorChannelID": "x", "values": [10, 20]}, {"sensorChannelID": "y", "values": [3, -1]},
    {"sensorChannelID": "t", "values": [0, 8]}, {"sensorChannelID": "l", "values": [100, 0]},
    {"sensorChannelID": "z", "values": [0, 0]}]}]}})");
  EXPECT_EQ(file.kind, "uim_json");
  ASSERT_EQ(file.strokes.size(), 1u);
  EXPECT_EQ(places(file.strokes[0]), "1 3, 3 2");
  EXPECT_DOUBLE_EQ(file.strokes[0].samples[1].time, 1600000000.508);
  // The upper end leans to +x: the tilt there is what is missing to upright.
  EXPECT_NEAR(file.strokes[0].samples[0].pen.tilt_x, M_PI / 2 - 1, 1e-6);
  EXPECT_NEAR(file.strokes[0].samples[0].pen.tilt_y, 0, 1e-6);
}

}  // namespace
}  // namespace burin
