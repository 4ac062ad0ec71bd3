// Puts the probe into hosts: one that breaks a rule on purpose, the command, and a session.
#include <burin/base/file.h>
#include <burin/host/session.h>
#include <burin/level_set/solid_mesh.h>
#include <burin/services/stamp_services.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <set>

#include "support/process.h"
#include "support/shapes.h"
#include "support/shared_data.h"

namespace burin {
namespace {

using Names = std::set<std::string>;
using test::ProcessResult;

const std::filesystem::path probe = BURIN_PROBE;

/// The names in a report's lines that begin with a word: "kept", "BROKEN" or "unseen".
Names rules(const std::string& report, const std::string& word) {
  const std::regex line("\n" + word + " +([a-z.-]+)");
  Names names;
  for (std::sregex_iterator at(report.begin(), report.end(), line), end; at != end; ++at)
    names.insert((*at)[1]);
  return names;
}

Names together(Names names, const Names& others) {
  names.insert(others.begin(), others.end());
  return names;
}

/// Runs a program that loads the probe, and returns the probe's report.
class ProbeReport {
 public:
  std::string of(const std::vector<std::string>& command) {
    std::filesystem::remove(path_);
    result = test::run_process(
        command, {"BURIN_PROBE_REPORT=" + path_, "BURIN_PLUGIN_PATH=" + probe.parent_path().string()});
    return std::filesystem::exists(path_) ? read_file(path_) : "";
  }

  /// Of what a session of this process does.
  template <class Draw>
  std::string of_session(const Draw& draw) {
    setenv("BURIN_PROBE_REPORT", path_.c_str(), 1);
    {
      BrushLibrary brushes(nullptr, stamp_services(read_vdb));
      brushes.load(probe);
      Session session(make_surface(test::sphere(4, 0.2, 6)), brushes, merge_solid);
      draw(session);
    }
    unsetenv("BURIN_PROBE_REPORT");
    return read_file(path_);
  }

  ProcessResult result;

 private:
  test::TemporaryFolder folder_;
  std::string path_ = (folder_.path() / "report.txt").string();
};

std::string of_wrong_host(const std::string& rule) {
  return ProbeReport().of({BURIN_WRONG_HOST, probe.string(), rule});
}

TEST(Probe, FindsNothingInAHostThatKeepsAllRules) {
  const std::string report = of_wrong_host("none");
  EXPECT_EQ(rules(report, "BROKEN"), Names());
  EXPECT_EQ(rules(report, "unseen"), Names());
  EXPECT_GT(rules(report, "kept").size(), 50u);
}

TEST(Probe, NamesTheOneRuleThatAHostBreaks) {
  for (const std::string& rule : rules(of_wrong_host("none"), "kept"))
    EXPECT_EQ(rules(of_wrong_host(rule), "BROKEN"), Names{rule});
}

TEST(Probe, TellsTheCallsInTheirOrderWithThreadsAndSizes) {
  const std::string report = of_wrong_host("none");
  EXPECT_NE(report.find("\n  evaluate       2, 10 nodes, 5 to 5 at a time\n"), std::string::npos) << report;
  EXPECT_NE(
      report.find("\n  thread 1: begin 1\n  thread 1: evaluate 1, 2 times, 10 nodes\n  thread 1: end 1\n"),
      std::string::npos)
      << report;
  EXPECT_NE(report.find("strokes drawn: 1, of which 0 ended without"), std::string::npos) << report;
}

/// A replay of sample strokes on a small mesh.
std::string of_replay(const std::string& brush, const std::vector<std::string>& options) {
  std::vector<std::string> command = {BURIN_COMMAND,
                                      "replay",
                                      BURIN_SAMPLES "/strokes/meander.stroke",
                                      BURIN_SAMPLES "/strokes/scale_band.stroke",
                                      "--mesh",
                                      BURIN_SAMPLES "/meshes/ewer.obj",
                                      "--target-triangles",
                                      "5000",
                                      "--show-every",
                                      "10",
                                      "--brush",
                                      brush};
  command.insert(command.end(), options.begin(), options.end());
  ProbeReport report;
  const std::string text = report.of(command);
  EXPECT_EQ(report.result.exit_code, 0) << report.result.err;
  return text;
}

TEST(Probe, FindsNothingWrongInReplays) {
  const std::vector<std::vector<std::string>> all_options = {
      {"--param", "passes=3", "--param", "height=0.5"},
      {"--mirror", "x", "--radial", "3"},
      {"--dabs", "0.5"},
      {"--closed", "yes", "--pressure-width", "0.5", "--cap", "butt"},
      {"--param", "passes=1", "--accumulate", "current", "--dynamic", "height=pressure:0,0,1,1"},
      {"--follow", "1", "--join", "overlap"},
      {"--isolate"}};
  for (const auto& options : all_options) {
    const std::string report = of_replay("org.burin.probe", options);
    EXPECT_EQ(rules(report, "BROKEN"), Names()) << options[0] << "\n" << report;
    EXPECT_GT(rules(report, "kept").size(), 40u);
  }
}

TEST(Probe, FindsNothingWrongWithSolidsAndMovedCurves) {
  for (const auto& options :
       std::vector<std::vector<std::string>>{{}, {"--solid", "separate", "--radial", "2"}}) {
    const std::string report = of_replay("org.burin.probe.solid", options);
    EXPECT_EQ(rules(report, "BROKEN"), Names()) << report;
    EXPECT_TRUE(rules(report, "kept").contains("curve.offsets"));
    EXPECT_EQ(rules(report, "kept").contains("solid.points"), !options.empty());
  }
}

/// A stroke over the north of the unit sphere.
void draw(Session& session, const StrokeSettings& settings, bool drop = false) {
  session.begin_stroke(settings);
  for (int i = 0; i < 12; ++i) {
    const double angle = 0.1 * i - 0.6;
    session.add_sample(Vec3d(std::sin(angle), 0.1, std::cos(angle)).normalized(), 0.01 * i, {});
  }
  if (drop)
    session.cancel_stroke();
  else
    session.end_stroke();
}

TEST(Probe, FindsNothingWrongInASessionThatDropsAndUndoesStrokes) {
  const std::string report = ProbeReport().of_session([](Session& session) {
    StrokeSettings settings;
    settings.brush = "org.burin.probe";
    settings.radius = 0.2;
    session.set_paint({std::vector<Vec4f>(session.surface().vertex_count(), Vec4f(0, 1, 0.5f, 1)),
                       std::vector<float>(session.surface().vertex_count(), 0.5f)});
    draw(session, settings);
    draw(session, settings, true);
    settings.symmetry.mirror_x = true;
    draw(session, settings);
    EXPECT_TRUE(session.undo());
    settings.dab_spacing = 0.5;
    draw(session, settings);
  });
  EXPECT_EQ(rules(report, "BROKEN"), Names()) << report;
  EXPECT_NE(report.find("strokes drawn: 4, of which 1 ended without"), std::string::npos) << report;
}

TEST(Probe, FindsNothingWrongInASessionThatMergesASolid) {
  const std::string report = ProbeReport().of_session([](Session& session) {
    StrokeSettings settings;
    settings.brush = "org.burin.probe.solid";
    settings.radius = 0.2;
    settings.solid = SolidOperation::unite;
    draw(session, settings);
  });
  EXPECT_EQ(rules(report, "BROKEN"), Names()) << report;
  EXPECT_TRUE(rules(report, "kept").contains("solid.points"));
}

TEST(Probe, HasNoFaultThatTheValidatorFinds) {
  const ProcessResult result = test::run_process({BURIN_COMMAND, "validate", probe.string(), "--quiet"});
  EXPECT_EQ(result.exit_code, 0) << result.out;
}

// The checks fill arrays that a brush did not declare, so that one who reads or writes them fails in one
// check instead of crashing in all.
TEST(Probe, FindsNothingElseWrongInTheValidator) {
  const Names on_purpose = {"batch.undeclared", "outputs.declared", "param.text"};
  for (const char* check : {"life.begin-random", "life.file-values", "life.many-strokes", "process.state",
                            "process.float-modes", "host.older", "host.newer", "host.missing-services",
                            "evaluate.batch-sizes", "evaluate.dab", "repeat.seed", "repeat.threads",
                            "ability.passes", "ability.state", "ability.volume", "ability.curve-filter"}) {
    const std::string report = ProbeReport().of({BURIN_COMMAND, "validate", probe.string(), "--only", check});
    EXPECT_GT(rules(report, "kept").size(), 5u) << check;
    EXPECT_EQ(together(rules(report, "BROKEN"), on_purpose), on_purpose) << check;
  }
}

}  // namespace
}  // namespace burin
