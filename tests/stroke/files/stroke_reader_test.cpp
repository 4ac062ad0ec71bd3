#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/stroke/files/setting_table.h>
#include <burin/stroke/stroke_file.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <iostream>
#include <nlohmann/json.hpp>
#include <random>

#include "support/shared_data.h"

namespace burin {
namespace {

std::string lines(const std::vector<std::string>& all) {
  std::string text;
  for (const std::string& line : all) text += line + "\n";
  return text;
}

const std::string header = R"({"burin_stroke": 1, "space": "object"})";
const std::string begin = R"({"begin": {}, "fields": ["time", "x", "y", "z"]})";
const std::string end = R"({"end": true})";
const std::string identity = "[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]";

std::string screen_header(const std::string& view, const std::string& projection,
                          const std::string& viewport) {
  return R"({"burin_stroke": 1, "space": "screen", "camera": {"view": )" + view + R"(, "projection": )" +
         projection + R"(, "viewport": )" + viewport + "}}";
}

const std::string rich_begin =
    R"({"begin": {"brush": "org.burin.scales", "radius": 0.05, "strength": 0.5, "follow": 0.25, "closed": true, )"
    R"("params": {"tile": "r\u00f6ck.exr", "depth": 2, "flip": true, "curve": [0, 0.5, 1, 1]}, "later": null, )"
    R"("dynamics": [{"target": "depth", "source": "t", "curve": [0, 0.5, 1, 2], "later": 1}]}, )"
    R"("fields": ["pressure","tilt_y","time","z","y","x","tilt_x","twist","wheel"]})";
const std::string rich_file = lines({header, rich_begin, R"([0.5, 0.2, 1.25, 3, 2, 1, 0.1, 0.3, "any"])",
                                     "[0.75, 0, 1.25, 3, 2, 1.5, 0, 0, null]", end, begin,
                                     "[0.000, 0.1, 0.2, 0.3]", "[0.008, 0.1, 0.25, -3e-1]", end});

class ReadStrokes : public ::testing::Test {
 protected:
  Recording read(const std::string& text) {
    write_file_whole(path_, [&](std::ostream& out) { out << text; });
    return read_strokes(path_);
  }

  /// The error message of read_strokes() for the text, without the path; "accepted" if there is none.
  std::string complaint(const std::string& text) {
    try {
      read(text);
    } catch (const FileError& error) {
      const std::string what = error.what();
      EXPECT_EQ(what.rfind(path_.string() + ":", 0), 0u) << what;
      EXPECT_EQ(what.find('\n'), what.npos) << what;
      return what.substr(path_.string().size() + 1);
    }
    return "accepted";
  }

  std::string sample_complaint(const std::string& sample) {
    return complaint(lines({header, begin, "[1, 0, 0, 0]", sample, end}));
  }

  std::string begin_complaint(const std::string& settings, const std::string& fields = R"(["x","y","z"])") {
    return complaint(lines({header, R"({"begin": )" + settings + R"(, "fields": )" + fields + "}", end}));
  }

  std::string camera_complaint(const std::string& view, const std::string& viewport) {
    return complaint(lines({screen_header(view, identity, viewport)}));
  }

  test::TemporaryFolder folder_;
  std::filesystem::path path_ = folder_.path() / "a.stroke";
};

TEST_F(ReadStrokes, ReadsEverySettingAndFieldsInAnyOrder) {
  const Recording recording = read(rich_file);
  EXPECT_EQ(recording.space, StrokeSpace::object);
  EXPECT_FALSE(recording.camera);
  EXPECT_FALSE(recording.cut_off_at);
  ASSERT_EQ(recording.strokes.size(), 2u);
  const RecordedStroke& stroke = recording.strokes[0];
  const ReplaySettings settings = stroke.settings.complete();
  EXPECT_EQ(settings.brush, "org.burin.scales");
  EXPECT_EQ(settings.radius, 0.05);
  EXPECT_EQ(settings.strength, 0.5);
  EXPECT_EQ(settings.follow, 0.25);
  EXPECT_EQ(settings.closure, Closure::closed);
  EXPECT_EQ(settings.params, (ParamSettings{{"tile", "r\u00f6ck.exr"},
                                            {"depth", 2.0},
                                            {"flip", true},
                                            {"curve", std::vector<double>{0, 0.5, 1, 1}}}));
  EXPECT_EQ(settings.dynamics, (std::vector<Dynamic>{{"depth", PenSource::t, {0, 0.5, 1, 2}}}));
  EXPECT_EQ(stroke.fields, (PenFields{true, true, true, true}));
  ASSERT_EQ(stroke.samples.size(), 2u);
  const Sample& sample = stroke.samples[0];
  EXPECT_EQ(sample.time, 1.25);
  EXPECT_EQ(sample.position, Vec3d(1, 2, 3));
  EXPECT_EQ(sample.pen.pressure, 0.5f);
  EXPECT_EQ(sample.pen.tilt_x, 0.1f);
  EXPECT_EQ(sample.pen.tilt_y, 0.2f);
  EXPECT_EQ(sample.pen.twist, 0.3f);
}

TEST_F(ReadStrokes, LeavesOpenWhatTheFileLeavesOpen) {
  const Recording recording =
      read(lines({header, R"({"begin": {}, "fields": ["x","y","z"]})", "[1,2,3]", end}));
  const RecordedStroke& stroke = recording.strokes.at(0);
  nlohmann::ordered_json given = nlohmann::ordered_json::object();
  write_settings(stroke.settings, given);
  EXPECT_EQ(given.size(), 0u) << given;
  EXPECT_EQ(stroke.fields, PenFields{});
  EXPECT_EQ(stroke.samples.at(0).pen.pressure, 1);
  EXPECT_EQ(stroke.samples.at(0).time, 0);
}

TEST_F(ReadStrokes, ReadsScreenSpaceWithColumnMajorMatrices) {
  const Recording recording =
      read(lines({screen_header("[1,2,0,0, 0,1,0,0, 0,0,1,0, 7,8,9,1]", identity, "[8, 6]"),
                  R"({"begin": {}, "fields": ["x","y"]})", "[3,4]", end}));
  EXPECT_EQ(recording.space, StrokeSpace::screen);
  EXPECT_EQ(recording.camera.value().view(1, 0), 2);
  EXPECT_EQ(recording.camera->view.topRightCorner(3, 1), Vec3d(7, 8, 9));
  EXPECT_EQ(recording.camera->width, 8);
  EXPECT_EQ(recording.camera->height, 6);
  EXPECT_EQ(recording.strokes.at(0).samples.at(0).position, Vec3d(3, 4, 0));
}

TEST_F(ReadStrokes, AcceptsBlankLinesAndCarriageReturnsAndStillCountsLines) {
  std::string text = "\n" + header + "\r\n\r\n  \n" + begin + "\r\n[1, 0, 0, 0]\r\n";
  EXPECT_EQ(read(text + end + "\r\n").strokes.at(0).samples.size(), 1u);
  EXPECT_EQ(complaint(text + "\r\n[1, 0, 0]\r\n"), "8: the sample has 3 values for 4 fields");
}

TEST_F(ReadStrokes, PassesOverObjectsOfKeysItDoesNotKnow) {
  EXPECT_EQ(
      read(lines({header, R"({"note": "hm"})", begin, R"({"note": 1})", "[1,0,0,0]", end})).strokes.size(),
      1u);
}

TEST_F(ReadStrokes, ReadsSamplesOfTheWriterAsAnyOtherJson) {
  const std::string numbers[] = {"0", "-0.0", "1e3", "-12.5E-3", "0.1", "3602879701896397", "1e-320"};
  std::string plain, spaced;
  for (std::size_t i = 0; i < std::size(numbers); ++i) {
    const std::string sample = fmt::format("{},{},{},7", i, numbers[i], numbers[std::size(numbers) - 1 - i]);
    plain += "[" + sample + "]\n";
    spaced += "[ " + sample + "]\n";
  }
  const Recording a = read(lines({header, begin}) + plain + end + "\n");
  const Recording b = read(lines({header, begin}) + spaced + end + "\n");
  ASSERT_EQ(a.strokes.at(0).samples.size(), std::size(numbers));
  for (std::size_t i = 0; i < std::size(numbers); ++i) {
    EXPECT_EQ(a.strokes[0].samples[i].time, b.strokes.at(0).samples.at(i).time);
    EXPECT_EQ(a.strokes[0].samples[i].position, b.strokes[0].samples[i].position) << numbers[i];
  }
  for (const char* number : {"01", "1.", ".5", "+1", "inf", "nan", "1e999", "0x1", "1.e3", "-", ""})
    EXPECT_THROW(read(lines({header, begin, fmt::format("[0,{},0,0]", number), end})), FileError) << number;
}

TEST_F(ReadStrokes, RejectsBadSamples) {
  EXPECT_EQ(sample_complaint("[1, 0, 0, 0]"), "accepted");
  EXPECT_EQ(sample_complaint("[0.5, 0, 0, 0]"), "4: time falls from 1 to 0.5");
  EXPECT_EQ(sample_complaint("[1, 0, 0]"), "4: the sample has 3 values for 4 fields");
  EXPECT_EQ(sample_complaint("[1, 0, 0, 0, 0]"), "4: the sample has 5 values for 4 fields");
  EXPECT_EQ(sample_complaint("[1, 1e999, 0, 0]"), "4: a number is too large");
  EXPECT_EQ(sample_complaint("[1, -1e40, 0, 0]"), "4: the position is not finite, or too large");
  EXPECT_EQ(sample_complaint("[1, null, 0, 0]"), "4: [1]: must be a number, not null");
  EXPECT_EQ(sample_complaint("[1, 0, \"0\", 0]"), "4: [2]: must be a number, not '0'");
  EXPECT_EQ(sample_complaint("[1, 0, true, 0]"), "4: [2]: must be a number, not true");
  EXPECT_EQ(sample_complaint("[1, NaN, 0, 0]"), "4: malformed JSON at column 5");
  EXPECT_EQ(sample_complaint("[1, Infinity, 0, 0]"), "4: malformed JSON at column 5");
  EXPECT_EQ(sample_complaint("[1, 0, 0, 0"), "4: malformed JSON at column 12");
  EXPECT_EQ(sample_complaint("[1, 0, 0, 0] [1, 0, 0, 0]"), "4: malformed JSON at column 14");
  EXPECT_EQ(sample_complaint(std::string("[1, 0, 0, 0]\0", 13)), "4: malformed JSON at column 13");
  EXPECT_EQ(sample_complaint("17"), "4: the line is neither an object nor a sample");
}

TEST_F(ReadStrokes, RejectsPenValuesOutOfRange) {
  const auto pen_complaint = [&](const std::string& field, const std::string& value) {
    return complaint(lines({header, R"({"begin": {}, "fields": ["x","y","z",")" + field + R"("]})",
                            "[0,0,0," + value + "]", end}));
  };
  EXPECT_EQ(pen_complaint("pressure", "1.01"), "3: pressure must lie in 0..1");
  EXPECT_EQ(pen_complaint("pressure", "-0.01"), "3: pressure must lie in 0..1");
  EXPECT_EQ(pen_complaint("tilt_x", "1e39"), "3: tilt or twist is not finite");
  EXPECT_EQ(pen_complaint("tilt_y", "-1e39"), "3: tilt or twist is not finite");
  EXPECT_EQ(pen_complaint("twist", "1e39"), "3: tilt or twist is not finite");
  EXPECT_EQ(pen_complaint("wheel", "1e39"), "accepted");
}

TEST_F(ReadStrokes, RejectsLinesOutOfOrder) {
  EXPECT_EQ(complaint(lines({header, "[1,0,0,0]"})), "2: a sample outside a stroke");
  EXPECT_EQ(complaint(lines({header, begin, end, "[1,0,0,0]"})), "4: a sample outside a stroke");
  EXPECT_EQ(complaint(lines({header, begin, begin})), "3: a stroke begins before the one before has its end");
  EXPECT_EQ(complaint(lines({header, end})), "2: an end outside a stroke");
  EXPECT_EQ(complaint(lines({header, begin, R"({"end": 1})"})), "3: end: must be true, not 1");
  EXPECT_EQ(complaint(lines({header, header})), "2: a second header");
  EXPECT_EQ(complaint(lines({begin, header})), R"(1: the header {"burin_stroke": 1, ...} must come first)");
  EXPECT_TRUE(complaint("x,y\n1,2\n").starts_with("1: no .stroke file, whose header"));
  EXPECT_EQ(complaint("{\"burin_stroke\": 1\n"), "1: malformed JSON at column 19");
  EXPECT_EQ(complaint(lines({"", "[1]"})), R"(2: the header {"burin_stroke": 1, ...} must come first)");
  EXPECT_EQ(complaint(""), R"(1: the header {"burin_stroke": 1, ...} is missing)");
  EXPECT_EQ(complaint("{\"burin_str"), R"(1: the header {"burin_stroke": 1, ...} is missing)");
}

TEST_F(ReadStrokes, RejectsBadHeaders) {
  EXPECT_EQ(complaint(lines({R"({"burin_stroke": 2, "space": "object"})"})),
            "1: burin_stroke: version 2 of the format is not known, only 1 is");
  EXPECT_EQ(complaint(lines({R"({"burin_stroke": "1", "space": "object"})"})),
            "1: burin_stroke: must be a number, not '1'");
  EXPECT_EQ(complaint(lines({R"({"burin_stroke": 1})"})), "1: lacks 'space'");
  EXPECT_EQ(complaint(lines({R"({"burin_stroke": 1, "space": "outer"})"})),
            "1: space: must be one of object, screen, not 'outer'");
  EXPECT_EQ(complaint(lines({R"({"burin_stroke": 1, "space": "screen"})"})),
            "1: lacks 'camera', which screen space needs");
  EXPECT_EQ(complaint(lines({R"({"burin_stroke": 1, "space": "screen", "camera": 3})"})),
            "1: camera: must be an object, not 3");
  EXPECT_EQ(complaint("{\"burin_stroke\": 1, \"space\": \"\xff\"}\n"), "1: malformed JSON at column 31");
}

TEST_F(ReadStrokes, RejectsBadCameras) {
  EXPECT_EQ(camera_complaint(identity, "[8, 6]"), "accepted");
  EXPECT_EQ(camera_complaint("[1, 2]", "[8, 6]"), "1: camera.view: has 2 numbers, a matrix needs 16");
  EXPECT_EQ(camera_complaint("7", "[8, 6]"), "1: camera.view: must be an array of numbers, not 7");
  EXPECT_EQ(camera_complaint("[null]", "[8, 6]"), "1: camera.view[0]: must be a number, not null");
  EXPECT_EQ(camera_complaint("[1,0,0,0, 0,1,0,0, 1,1,0,0, 0,0,0,1]", "[8, 6]"),
            "1: camera: the view matrix has no inverse");
  for (const char* viewport : {"[8]", "[8, 6, 1]"})
    EXPECT_EQ(camera_complaint(identity, viewport),
              "1: camera.viewport: must be two whole numbers of pixels");
  for (const char* width : {"6.5", "0", "-6", "5000000000"})
    EXPECT_EQ(
        camera_complaint(identity, fmt::format("[{}, 8]", width)),
        fmt::format("1: camera.viewport[0]: must be a whole number from 1 to 2147483647, not {}", width));
  EXPECT_EQ(camera_complaint(identity, "8"), "1: camera.viewport: must be an array, not 8");
}

TEST_F(ReadStrokes, RejectsBadSettings) {
  EXPECT_EQ(begin_complaint("{}"), "accepted");
  EXPECT_EQ(begin_complaint("3"), "2: begin: must be an object, not 3");
  EXPECT_EQ(begin_complaint(R"({"brush": 3})"), "2: begin.brush: must be a text, not 3");
  EXPECT_EQ(begin_complaint(R"({"radius": 0})"), "2: begin.radius: must be a number above 0, not 0");
  EXPECT_EQ(begin_complaint(R"({"radius": -0.1})"), "2: begin.radius: must be a number above 0, not -0.1");
  EXPECT_EQ(begin_complaint(R"({"radius": null})"), "2: begin.radius: must be a number above 0, not null");
  EXPECT_EQ(begin_complaint(R"({"strength": "1"})"), "2: begin.strength: must be a number, not '1'");
  EXPECT_EQ(begin_complaint(R"({"follow": "all"})"), "2: begin.follow: must be a number, not 'all'");
  EXPECT_EQ(begin_complaint(R"({"follow": 1.01})"),
            "2: begin.follow: must be a number from 0 to 1, not 1.01");
  EXPECT_EQ(begin_complaint(R"({"follow": -0.5})"),
            "2: begin.follow: must be a number from 0 to 1, not -0.5");
  EXPECT_EQ(begin_complaint(R"({"closed": 1})"), "2: begin.closed: must be one of auto, no, yes, not 1");
  EXPECT_EQ(begin_complaint(R"({"params": []})"), "2: begin.params: must be an object");
  EXPECT_EQ(begin_complaint(R"({"params": {"depth": null}})"),
            "2: begin.params.depth: must be a number, not null");
  EXPECT_EQ(begin_complaint(R"({"params": {"a\nb": {}}})"), R"(2: begin.params.'a\x0ab': must be a number)");
  EXPECT_EQ(begin_complaint(R"({"params": {"curve": [0, "1"]}})"),
            "2: begin.params.curve[1]: must be a number, not '1'");
}

TEST_F(ReadStrokes, RejectsBadDynamics) {
  const auto dynamic_complaint = [&](const std::string& dynamic) {
    return begin_complaint(R"({"dynamics": [)" + dynamic + "]}");
  };
  const auto curve_complaint = [&](const std::string& curve) {
    return dynamic_complaint(R"({"target": "radius", "source": "tilt", "curve": )" + curve + "}");
  };
  EXPECT_EQ(curve_complaint("[0, 0, 1, 1]"), "accepted");
  EXPECT_EQ(curve_complaint("[0.5, 2]"), "accepted");
  EXPECT_EQ(begin_complaint(R"({"dynamics": {}})"), "2: begin.dynamics: must be an array");
  EXPECT_EQ(dynamic_complaint("3"), "2: begin.dynamics[0]: must be an object, not 3");
  EXPECT_EQ(dynamic_complaint(R"({"source": "tilt", "curve": [0, 0]})"),
            "2: begin.dynamics[0]: lacks 'target'");
  EXPECT_EQ(dynamic_complaint(R"({"target": 1, "source": "tilt", "curve": [0, 0]})"),
            "2: begin.dynamics[0].target: must be a text, not 1");
  EXPECT_EQ(dynamic_complaint(R"({"target": "radius", "source": "wheel", "curve": [0, 0]})"),
            "2: begin.dynamics[0].source: must be one of pressure, tilt, tilt_direction, direction, speed, "
            "time, t, random, not 'wheel'");
  EXPECT_EQ(dynamic_complaint(R"({"target": "radius", "source": "tilt"})"),
            "2: begin.dynamics[0]: lacks 'curve'");
  EXPECT_EQ(curve_complaint("1"), "2: begin.dynamics[0].curve: must be an array of numbers, not 1");
  EXPECT_EQ(curve_complaint("[]"), "2: begin.dynamics[0]: a dynamic's curve must be pairs of numbers x y");
  EXPECT_EQ(curve_complaint("[0, 0, 1]"),
            "2: begin.dynamics[0]: a dynamic's curve must be pairs of numbers x y");
  EXPECT_EQ(curve_complaint("[0, 0, 0, 1]"), "2: begin.dynamics[0]: the x of a dynamic's curve must rise");
  EXPECT_EQ(curve_complaint("[0, 1e39]"), "2: begin.dynamics[0]: a dynamic's curve must be finite");
}

TEST_F(ReadStrokes, CutsLongWordsAndEscapesControls) {
  const std::string word(250000, 'w'), escape = R"(\u001b[2J)";
  EXPECT_LT(begin_complaint(R"({"params": {")" + word + R"(": {}}})").size(), 200u);
  EXPECT_LT(begin_complaint("{}", R"(["x","y",")" + word + R"(",")" + word + R"("])").size(), 200u);
  EXPECT_EQ(begin_complaint("{}", R"(["x","y",")" + escape + R"(",")" + escape + R"("])"),
            R"(2: fields: name '\x1b[2J' twice)");
}

TEST_F(ReadStrokes, RejectsBadFields) {
  EXPECT_EQ(begin_complaint("{}", R"(["x","y"])"), "2: fields: lack z, which object space needs");
  EXPECT_EQ(begin_complaint("{}", R"(["x","z"])"), "2: fields: lack x or y");
  EXPECT_EQ(begin_complaint("{}", R"(["x","y","z","x"])"), R"(2: fields: name 'x' twice)");
  EXPECT_EQ(begin_complaint("{}", R"(["x","y","z","w","w"])"), R"(2: fields: name 'w' twice)");
  EXPECT_EQ(begin_complaint("{}", R"("xyz")"), "2: fields: must be an array, not 'xyz'");
  EXPECT_EQ(begin_complaint("{}", R"(["x","y","z",1])"), "2: fields[3]: must be a text, not 1");
  EXPECT_EQ(complaint(lines({header, R"({"begin": {}})"})), "2: lacks 'fields'");
}

TEST_F(ReadStrokes, RejectsDeepNestingWithoutRunningOutOfStack) {
  const std::string deep(1000000, '[');
  const std::string closed = deep + std::string(deep.size(), ']');
  EXPECT_EQ(sample_complaint(deep), "4: malformed JSON at column 1000001");
  EXPECT_EQ(sample_complaint("[1, 0, 0, " + closed + "]"), "4: [3]: must be a number");
  EXPECT_EQ(begin_complaint("{}", closed), "2: fields[0]: must be a text");
}

/// Samples that survive when the file ends after `size` bytes: those whose line is complete but for the
/// newline.
std::size_t samples_before(const std::string& text, std::size_t size) {
  std::size_t samples = 0;
  for (std::size_t at = 0; (at = text.find("]\n", at)) != text.npos && at < size; ++at)
    if (text[text.rfind('\n', at) + 1] == '[') ++samples;
  return samples;
}

TEST_F(ReadStrokes, KeepsAllWholeLinesOfARecordingCutAnywhere) {
  const std::size_t header_size = header.size();
  for (std::size_t size = 0; size < rich_file.size(); ++size) {
    SCOPED_TRACE(size);
    const std::string text = rich_file.substr(0, size);
    if (size < header_size) {
      EXPECT_EQ(complaint(text), R"(1: the header {"burin_stroke": 1, ...} is missing)");
      continue;
    }
    const Recording recording = read(text);
    std::size_t samples = 0;
    for (const RecordedStroke& stroke : recording.strokes) samples += stroke.samples.size();
    EXPECT_EQ(samples, samples_before(rich_file, size));
    const std::string last = text.substr(text.find_last_of('\n', size - 2) + 1);
    const bool between_strokes = last == end || last == end + "\n" || last == header || last == header + "\n";
    EXPECT_EQ(recording.cut_off_at.has_value(), !between_strokes);
  }
}

TEST_F(ReadStrokes, ReadsOrRefusesWhateverABrokenDiskMakesOfAFile) {
  const unsigned seed = std::random_device{}();
  std::cout << "seed " << seed << "\n";
  std::mt19937 random(seed);
  const auto below = [&](std::size_t limit) { return random() % limit; };
  int read_well = 0, refused = 0;
  for (int i = 0; i < 2000; ++i) {
    std::string text = rich_file;
    if (below(3) == 0) text.resize(below(text.size()));
    for (std::size_t change = below(4); change > 0 && !text.empty(); --change) {
      const std::size_t at = below(text.size());
      if (below(2) == 0)
        text[at] = static_cast<char>(below(256));
      else
        text.insert(at, text.substr(below(text.size()), below(40)));
    }
    (complaint(text) == "accepted" ? read_well : refused)++;
  }
  EXPECT_GT(read_well, 200);
  EXPECT_GT(refused, 200);
}

TEST_F(ReadStrokes, NamesAFileThatIsNotThere) {
  EXPECT_THROW(read_strokes(folder_.path() / "none.stroke"), FileError);
}

}  // namespace
}  // namespace burin
