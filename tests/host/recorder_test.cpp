#include <burin/host/recorder.h>
#include <burin/stroke/stroke_file.h>
#include <gtest/gtest.h>

#include <limits>

#include "support/process.h"
#include "support/shared_data.h"

namespace burin {
namespace {

/// Calls of the recorder with a buffer for its texts.
class RecorderInC : public testing::Test {
 protected:
  burin_recorder* open(burin_stroke_space space, const burin_recorder_camera* camera = nullptr) {
    const burin_recorder_options options = {sizeof options, space, path_.c_str(), nullptr, camera};
    return burin_recorder_open(&options, &text_);
  }
  burin_status begin(burin_recorder* recorder, const char* settings, std::uint32_t fields) {
    const burin_recorded_stroke stroke = {sizeof stroke, fields, settings, tool_, 0, 0};
    return burin_recorder_begin(recorder, &stroke, &text_);
  }

  test::TemporaryFolder folder_;
  const std::string path_ = (folder_.path() / "a.stroke").string();
  std::string line_ = std::string(200, ' ');
  burin_text text_{sizeof text_, 200, line_.data()};
  const char* tool_ = nullptr;
  burin_recorded_sample sample_{sizeof sample_, 0.5F, 1, {1, 2, 3}, 0, 0, 0, 0};
};

const char* const groove = R"({"brush": "org.burin.groove", "radius": 0.05})";

TEST_F(RecorderInC, RecordsFromAProgramInC) {
  const test::ProcessResult result = test::run_process({BURIN_RECORD_IN_C, path_});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "stroke file: time falls\nstroke file: begin within a stroke\n");
  const Recording recording = read_strokes(path_);
  EXPECT_EQ(recording.device, "Tablet of C");
  EXPECT_FALSE(recording.cut_off_at);
  ASSERT_EQ(recording.strokes.size(), 2u);
  const RecordedStroke& stroke = recording.strokes[0];
  EXPECT_EQ(stroke.settings.complete().brush, "org.burin.groove");
  EXPECT_EQ(stroke.settings.complete().params.at("depth"), ParamSetting(0.25));
  EXPECT_EQ(stroke.fields, (PenFields{true, true, true, true, true}));
  EXPECT_EQ(stroke.drawn_by, (DrawnBy{"pen", true}));
  ASSERT_EQ(stroke.samples.size(), 2u);
  EXPECT_EQ(stroke.samples[0].time, 1.25);
  EXPECT_EQ(stroke.samples[0].position, Vec3d(1, 2, 3));
  EXPECT_EQ(stroke.samples[0].pen.pressure, 0.5F);
  EXPECT_EQ(stroke.samples[0].pen.tilt_x, 0.1F);
  EXPECT_EQ(stroke.samples[0].pen.tilt_y, -0.2F);
  EXPECT_EQ(stroke.samples[0].pen.twist, 0.3F);
  EXPECT_FALSE(stroke.samples[0].barrel);
  EXPECT_TRUE(stroke.samples[1].barrel);
  EXPECT_EQ(recording.strokes[1].fields, PenFields());
  EXPECT_FALSE(recording.strokes[1].samples.at(0).barrel) << "a mouse does not report it";
  EXPECT_EQ(recording.strokes[1].drawn_by, DrawnBy());
}

TEST_F(RecorderInC, LosesNothingOfAProgramThatIsKilled) {
  EXPECT_NE(test::run_process({BURIN_RECORD_IN_C, path_, "kill"}).exit_code, 0);
  const Recording recording = read_strokes(path_);
  ASSERT_EQ(recording.strokes.size(), 1u);
  EXPECT_EQ(recording.strokes[0].samples.size(), 2u);
}

TEST_F(RecorderInC, RecordsPixelsOfACamera) {
  burin_recorder_camera camera = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, -7, 1},
                                  {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, -1, 0, 0, -0.2, 0},
                                  640,
                                  480};
  burin_recorder* const recorder = open(BURIN_SPACE_SCREEN, &camera);
  ASSERT_TRUE(recorder) << line_;
  EXPECT_EQ(begin(recorder, groove, BURIN_PEN_TIME), BURIN_OK);
  sample_.tilt_x = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(burin_recorder_add(recorder, &sample_, &text_), BURIN_OK) << "the pen reports no tilt";
  burin_recorder_close(recorder);
  const Recording recording = read_strokes(path_);
  ASSERT_TRUE(recording.camera);
  EXPECT_EQ(recording.camera->view(0, 3), 5) << "by columns";
  EXPECT_EQ(recording.camera->width, 640);
  EXPECT_EQ(recording.strokes.at(0).fields, PenFields{.time = true});
  EXPECT_EQ(recording.strokes[0].samples.at(0).position.y(), 2);
}

TEST_F(RecorderInC, RefusesWhatBreaksTheContract) {
  EXPECT_EQ(open(BURIN_SPACE_UNKNOWN), nullptr);
  EXPECT_STREQ(line_.c_str(), "space is neither object nor screen");
  EXPECT_EQ(open(BURIN_SPACE_SCREEN), nullptr) << "without a camera";
  EXPECT_EQ(burin_recorder_open(nullptr, &text_), nullptr);
  burin_recorder* const recorder = open(BURIN_SPACE_OBJECT);
  ASSERT_TRUE(recorder);
  EXPECT_EQ(burin_recorder_add(recorder, &sample_, &text_), BURIN_INVALID_ARGUMENT) << "outside a stroke";
  EXPECT_EQ(burin_recorder_end(recorder, &text_), BURIN_INVALID_ARGUMENT);
  EXPECT_EQ(begin(recorder, R"({"brush": "org.burin.groove"})", 0), BURIN_INVALID_ARGUMENT);
  EXPECT_EQ(begin(recorder, R"({"brush": "a", "radius": -1})", 0), BURIN_INVALID_ARGUMENT);
  EXPECT_EQ(begin(recorder, "{", 0), BURIN_INVALID_ARGUMENT);
  EXPECT_EQ(begin(recorder, nullptr, 0), BURIN_INVALID_ARGUMENT);
  tool_ = "\xff";
  EXPECT_EQ(begin(recorder, groove, 0), BURIN_INVALID_ARGUMENT);
  EXPECT_STREQ(line_.c_str(), "stroke file: a text is not valid UTF-8");
  tool_ = "pen";
  EXPECT_EQ(begin(recorder, groove, 0), BURIN_OK) << line_;
  sample_.struct_size = 4;
  EXPECT_EQ(burin_recorder_add(recorder, &sample_, &text_), BURIN_INVALID_ARGUMENT);
  sample_.struct_size = sizeof sample_;
  sample_.position[1] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(burin_recorder_add(recorder, &sample_, &text_), BURIN_INVALID_ARGUMENT);
  EXPECT_EQ(burin_recorder_end(nullptr, &text_), BURIN_INVALID_ARGUMENT);
  burin_recorder_close(recorder);
  burin_recorder_close(nullptr);
  EXPECT_TRUE(read_strokes(path_).strokes.at(0).samples.empty());
}

/// Callers that were compiled with the first version of the header, and with a later one.
TEST_F(RecorderInC, TakesStructsOfEveryVersion) {
  constexpr std::uint32_t first_options = 32, first_stroke = 16, first_sample = 56, later = 400;
  for (const std::uint32_t more : {0U, later}) {
    burin_recorder_options options = {sizeof options, BURIN_SPACE_OBJECT, path_.c_str(), nullptr, nullptr};
    options.struct_size = first_options + more;
    burin_recorder* const recorder = burin_recorder_open(&options, &text_);
    ASSERT_TRUE(recorder) << line_;
    const burin_recorded_stroke stroke = {first_stroke + more, BURIN_PEN_TWIST, groove, "pen", 1, 0};
    EXPECT_EQ(burin_recorder_begin(recorder, &stroke, &text_), BURIN_OK) << line_;
    sample_.struct_size = first_sample + more;
    sample_.twist = 0.25F;
    sample_.barrel = 7;  // was reserved, and need not be 0
    EXPECT_EQ(burin_recorder_add(recorder, &sample_, &text_), BURIN_OK) << line_;
    sample_.struct_size = first_sample - 1;
    EXPECT_EQ(burin_recorder_add(recorder, &sample_, &text_), BURIN_INVALID_ARGUMENT);
    burin_recorder_close(recorder);
    const RecordedStroke read = read_strokes(path_).strokes.at(0);
    EXPECT_EQ(read.samples.at(0).pen.twist, 0.25F);
    EXPECT_FALSE(read.samples[0].barrel);
    EXPECT_EQ(read.drawn_by, more == 0 ? DrawnBy() : (DrawnBy{"pen", true}));
  }
}

TEST_F(RecorderInC, NamesAFileThatCannotBeWritten) {
  const std::string path = (folder_.path() / "missing/a.stroke").string();
  const burin_recorder_options options = {sizeof options, BURIN_SPACE_OBJECT, path.c_str(), nullptr, nullptr};
  EXPECT_EQ(burin_recorder_open(&options, &text_), nullptr);
  EXPECT_NE(line_.find(path), std::string::npos) << line_;
}

}  // namespace
}  // namespace burin
