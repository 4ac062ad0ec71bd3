#include <burin/base/file.h>
#include <burin/ink/pen_file.h>
#include <burin/stroke/stroke_file.h>
#include <gtest/gtest.h>

#include "host_stub/run_command.h"
#include "stroke/recordings.h"

namespace burin::test {
namespace {

/// A stroke with all fields, one without any.
const char* const strokes = R"({"burin_stroke": 1, "space": "object"}
{"begin": {"radius": 0.1}, "fields": ["time", "x", "y", "z", "pressure", "tilt_x", "tilt_y", "twist"]}
[0.1, 0.3333333333333333, 2, 3, 0.1, 0.2, -0.3, 4]
[0.1, 0.3333333333333333, 2, 3, 0.1, 0.2, -0.3, 4]
{"end": true}
{"begin": {}, "fields": ["x", "y", "z"]}
[1e-7, 2, -3]
{"end": true}
{"begin": {}, "fields": ["x", "y", "z"]}
{"end": true}
)";

TEST(ExportCommand, WritesEverySampleOfSeveralRecordings) {
  const CommandFolder folder;
  const std::string a = folder.write("a.stroke", strokes),
                    b = folder.write("b.stroke", equator_stroke(0, 1, 20, ""));
  std::vector<RecordedStroke> expected = read_strokes(a).strokes;
  expected.pop_back();
  expected.push_back(read_strokes(b).strokes.at(0));
  for (const std::string name : {"out.inkml", "out.csv"}) {
    const ProcessResult result = burin({"export", a, b, "--out", folder.path(name)});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.out, folder.path(name) + ": 3 strokes, 23 samples\n");
    EXPECT_EQ(result.err, "burin: warning: strokes without samples, left out: 1\n");
    const PenFile file = read_pen_file(folder.path(name));
    ASSERT_EQ(file.strokes.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(file.strokes[i].fields, expected[i].fields) << name;
      ASSERT_EQ(file.strokes[i].samples.size(), expected[i].samples.size()) << name;
      for (std::size_t k = 0; k < expected[i].samples.size(); ++k)
        EXPECT_TRUE(same_bits(file.strokes[i].samples[k], expected[i].samples[k])) << name;
    }
  }
}

TEST(ExportCommand, WritesWhatImportReadsBack) {
  const CommandFolder folder;
  const std::string mesh = folder.write("cube.obj", cube_obj());
  const std::string csv =
      folder.write("a.csv", "stroke,x,y,time,pressure\n1,10,20,0.5,0.25\n1,90,20,0.625,1\n2,50,100,2,0\n");
  const auto import = [&](const std::string& file, const std::string& out) {
    burin_output(
        {"import", file, "--mesh", mesh, "--width", "125", "--height", "100", "--out", folder.path(out)});
    return read_strokes(folder.path(out));
  };
  const Recording once = import(csv, "a.stroke");
  ASSERT_EQ(once.strokes.size(), 2u);
  EXPECT_EQ(once.strokes[0].samples[1].position, Vec3d(102.5, 10, 0)) << "fitted, a margin of a tenth";
  for (const std::string name : {"b.inkml", "b.csv"}) {
    burin_output({"export", folder.path("a.stroke"), "--out", folder.path(name)});
    const Recording again = import(folder.path(name), "c.stroke");
    ASSERT_EQ(again.strokes.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
      ASSERT_EQ(again.strokes[i].samples.size(), once.strokes[i].samples.size());
      EXPECT_EQ(again.strokes[i].fields, once.strokes[i].fields);
      for (std::size_t k = 0; k < once.strokes[i].samples.size(); ++k) {
        EXPECT_NEAR((again.strokes[i].samples[k].position - once.strokes[i].samples[k].position).norm(), 0,
                    1e-9);
        EXPECT_EQ(again.strokes[i].samples[k].time, once.strokes[i].samples[k].time);
        EXPECT_EQ(again.strokes[i].samples[k].pen.pressure, once.strokes[i].samples[k].pen.pressure);
      }
    }
  }
}

TEST(ExportCommand, RefusesWithOneLineAndWritesNothing) {
  const CommandFolder folder;
  const std::string a = folder.write("a.stroke", strokes),
                    bad = folder.write("bad.stroke", "{\"burin_stroke\": 1}\n");
  const auto refusal = [&](const std::vector<std::string>& arguments) {
    const auto before = folder.content();
    const ProcessResult result = burin(arguments);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(folder.content(), before);
    return result.err;
  };
  const std::string svg = folder.path("out.svg"), csv = folder.path("out.csv");
  EXPECT_EQ(refusal({"export", a, "--out", svg}),
            "burin: " + svg + ": strokes are exported as .inkml or .csv\n");
  EXPECT_EQ(refusal({"export", a, bad, "--out", csv}), "burin: " + bad + ":1: lacks 'space'\n");
  const std::string events = folder.write("e.events", "# EVEMU 1.2\nE: 1 0003 0000\n"),
                    mesh = folder.write("cube.obj", cube_obj());
  EXPECT_EQ(refusal({"import", events, "--mesh", mesh, "--out", folder.path("e.stroke")}),
            "burin: " + events + ":2: expected an event: time type code value\n");
}

}  // namespace
}  // namespace burin::test
