#include <burin/surface/mesh_file.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "host_stub/run_command.h"
#include "support/shapes.h"

namespace burin::test {
namespace {

constexpr const char* groove = "\"brush\":\"org.burin.groove\",\"radius\":0.15";

/// A fine unit sphere and a short groove on its equator, to one side of every mirror plane but y = 0.
struct Ball {
  CommandFolder folder;
  TriangleMesh mesh = sphere(5, 0, 1);
  std::string mesh_path = folder.write("sphere.obj", obj_text(mesh));
  std::string stroke = folder.write("a.stroke", equator_stroke(0.4, 0.9, 31, groove));

  std::vector<std::string> command(const std::vector<std::string>& options) const {
    std::vector<std::string> arguments = {"replay", stroke, "--mesh", mesh_path};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return arguments;
  }

  std::vector<Vec3f> result(std::vector<std::string> options) const {
    options.insert(options.end(), {"--save-mesh", folder.path("out.ply")});
    burin_output(command(options));
    return read_mesh(folder.path("out.ply")).positions;
  }

  /// Vertices that a replay moves, where `counts` holds of their places before.
  template <class Counts>
  int moved(const std::vector<std::string>& options, const Counts& counts) const {
    const std::vector<Vec3f> after = result(options);
    int count = 0;
    for (std::size_t i = 0; i < after.size(); ++i)
      count += after[i] != mesh.positions[i] && counts(mesh.positions[i]) ? 1 : 0;
    return count;
  }
  int moved(const std::vector<std::string>& options) const {
    return moved(options, [](const Vec3f&) { return true; });
  }

  /// Lengths by which vertices went.
  std::vector<float> ways(const std::vector<std::string>& options) const {
    std::vector<float> lengths = {};
    const std::vector<Vec3f> after = result(options);
    for (std::size_t i = 0; i < after.size(); ++i) lengths.push_back((after[i] - mesh.positions[i]).norm());
    return lengths;
  }
};

TEST(SettingEffects, MirrorAlongEveryAxisNamed) {
  const Ball ball;
  const int once = ball.moved({});
  ASSERT_GT(once, 100);
  const auto left = [](const Vec3f& p) { return p.x() < 0; };
  EXPECT_EQ(ball.moved({}, left), 0);
  // The icosahedron is its own mirror image across the planes of its axes.
  EXPECT_EQ(ball.moved({"--mirror", "x"}, left), once);
  EXPECT_EQ(ball.moved({"--mirror", "x"}), 2 * once);
  EXPECT_EQ(ball.moved({"--mirror", "xz"}), 4 * once);
  EXPECT_EQ(ball.moved({"--mirror", "z"}, [](const Vec3f& p) { return p.z() < 0 && p.x() > 0; }), once);
}

TEST(SettingEffects, TurnAroundTheAxisGiven) {
  const Ball ball;
  const int once = ball.moved({});
  EXPECT_NEAR(ball.moved({"--radial", "4"}), 4 * once, 0.1 * 4 * once) << "around y";
  EXPECT_EQ(ball.result({"--radial", "4"}), ball.result({"--radial", "4", "--radial-axis", "y"}));
  EXPECT_EQ(ball.moved({"--radial", "2", "--radial-axis", "z"},
                       [](const Vec3f& p) { return p.x() < 0 && p.z() > 0; }),
            once);
  EXPECT_EQ(ball.moved({"--radial", "2", "--radial-axis", "x"},
                       [](const Vec3f& p) { return p.x() > 0 && p.z() < 0; }),
            once);
  EXPECT_EQ(ball.result({"--radial", "1", "--radial-axis", "x"}), ball.result({}));
}

TEST(SettingEffects, MoveTheCentreOfSymmetry) {
  const Ball ball;
  EXPECT_EQ(ball.result({"--mirror", "x", "--symmetry-centre", "0,5,-3"}), ball.result({"--mirror", "x"}));
  const int once = ball.moved({});
  EXPECT_EQ(ball.moved({"--mirror", "x", "--symmetry-centre", "9,0,0"}), once) << "its image is far away";
}

TEST(SettingEffects, DrawRowsOfDabs) {
  const Ball ball;
  const int stroke = ball.moved({}), rare = ball.moved({"--dabs", "4"}),
            dense = ball.moved({"--dabs", "0.5"});
  EXPECT_GT(rare, 0);
  EXPECT_LT(rare, dense);
  EXPECT_LE(dense, 2 * stroke);
  EXPECT_NE(ball.result({"--dabs", "0.5"}), ball.result({}));
}

TEST(SettingEffects, ClampWaysToOneRadius) {
  const Ball ball;
  const std::vector<std::string> far = {"--strength", "8"};
  const float radius = 0.15f;
  EXPECT_GT(std::ranges::max(ball.ways(far)), 1.5f * radius);
  EXPECT_NEAR(std::ranges::max(ball.ways({"--strength", "8", "--clamp"})), radius, 1e-5f);
  EXPECT_EQ(ball.result({"--clamp"}), ball.result({}));
}

TEST(SettingEffects, AccumulateOntoWhatTheStrokeMade) {
  Ball ball;
  ball.stroke = ball.folder.write("b.stroke", equator_stroke(0, 12, 601, groove));
  const float base = std::ranges::max(ball.ways({})),
              current = std::ranges::max(ball.ways({"--accumulate", "current"}));
  EXPECT_EQ(ball.result({"--accumulate", "base"}), ball.result({}));
  EXPECT_NEAR(current, 2 * base, 0.1f * base) << "it comes round twice";
}

struct BadOption {
  std::string option, value, culprit;
};

TEST(SettingEffects, RefuseWhatTheyDoNotTakeInOneLine) {
  const Ball ball;
  const auto before = ball.folder.content();
  for (const auto& [option, value, culprit] :
       std::vector<BadOption>{{"--mirror", "w", "x, y, z"},
                              {"--mirror", "", "--mirror"},
                              {"--radial", "0", "--radial"},
                              {"--radial", "129", "--radial"},
                              {"--radial", "2.5", "--radial"},
                              {"--radial-axis", "w", "--radial-axis"},
                              {"--radial-axis", "", "--radial-axis"},
                              {"--radial-axis", "x", "--radial"},
                              {"--symmetry-centre", "1,2", "three numbers"},
                              {"--symmetry-centre", "1,2,nan", "three numbers"},
                              {"--dabs", "0", "--dabs"},
                              {"--dabs", "-1", "--dabs"},
                              {"--dabs", "0.001", "dab"},
                              {"--accumulate", "sum", "--accumulate"}}) {
    SCOPED_TRACE(option + " " + value);
    const ProcessResult result =
        burin(ball.command({option, value, "--save-mesh", ball.folder.path("out.ply")}));
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err.rfind("burin: ", 0), 0u) << result.err;
    EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
    EXPECT_NE(result.err.find(culprit), std::string::npos) << result.err;
    EXPECT_EQ(ball.folder.content(), before);
  }
}

class TextParam : public ::testing::Test {
 protected:
  std::string hash(const std::string& setting) const {
    return burin_json(ball_.command({"--brush", "org.burin.text", "--param", setting}))["result_hash"];
  }

  Ball ball_;
};

TEST_F(TextParam, StaysAsItWasTyped) {
  std::vector<std::string> hashes;
  for (const char* text : {"7", "007", "7.0", "true", "1,2", "Ä", "A"})
    hashes.push_back(hash("text=" + std::string(text)));
  std::vector<std::string> different = hashes;
  std::ranges::sort(different);
  EXPECT_EQ(std::ranges::unique(different).size(), 0u);
  EXPECT_EQ(hash("text=Burin"), burin_json(ball_.command({"--brush", "org.burin.text"}))["result_hash"]);
}

TEST_F(TextParam, OfARecordingsOwnBrushToo) {
  ball_.stroke = ball_.folder.write(
      "b.stroke",
      equator_stroke(0.4, 0.9, 31,
                     "\"brush\":\"org.burin.text\",\"radius\":0.15,\"params\":{\"text\":\"007\"}"));
  const auto recorded = burin_json(ball_.command({}))["result_hash"];
  EXPECT_EQ(burin_json(ball_.command({"--param", "text=007"}))["result_hash"], recorded);
  EXPECT_NE(burin_json(ball_.command({"--param", "text=7"}))["result_hash"], recorded);
}

TEST_F(TextParam, MustBeUtf8) {
  const ProcessResult result =
      burin(ball_.command({"--brush", "org.burin.text", "--param", "text=\xff\xfe"}));
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find("'text'"), std::string::npos) << result.err;
  EXPECT_EQ(std::ranges::count(result.err, '\n'), 1);
}

}  // namespace
}  // namespace burin::test
