#include <burin/ink/pen_file_writers.h>

#include <iostream>
#include <random>
#include <sstream>

#include "ink/pen_files.h"
#include "stroke/recordings.h"

namespace burin {
namespace {

/// Names of tools, of which some need quotes in every format, or where tables have words for no name.
const char* const tools[] = {"pen", "a \"felt\" <pen>, 1 & 2;\u00e9\nof two lines", "None", " a pen "};

/// Strokes with all fields, with some and with none, whose numbers have all their bits.
std::vector<Recording> recordings() {
  const unsigned seed = std::random_device{}();
  std::cout << "seed " << seed << "\n";
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> place(-1000, 1000), share(0, 1), angle(-1.5, 1.5);
  std::vector<Recording> all(2);
  all[1].space = StrokeSpace::screen;
  for (Recording& recording : all)
    for (const PenFields& fields : {PenFields{true, true, true, true}, PenFields{},
                                    PenFields{.pressure = true}, PenFields{.time = true}}) {
      RecordedStroke& stroke = recording.strokes.emplace_back();
      stroke.fields = fields;
      stroke.fields.barrel = fields.pressure;
      const std::size_t number = recording.strokes.size(), first = &recording == &all[0] ? 0 : 2;
      stroke.drawn_by = {number % 2 == 0 ? "" : tools[first + number / 2], fields.twist};
      double time = 1.7e9;
      for (int i = 0; i < 300; ++i) {
        Sample& sample = stroke.samples.emplace_back();
        sample.position = {place(random), place(random),
                           recording.space == StrokeSpace::object ? place(random) : 0};
        if (fields.time) sample.time = time += share(random) / 100;
        if (fields.pressure) sample.pen.pressure = static_cast<float>(share(random));
        if (fields.tilt) {
          sample.pen.tilt_x = static_cast<float>(angle(random));
          sample.pen.tilt_y = static_cast<float>(angle(random));
        }
        if (fields.twist) sample.pen.twist = static_cast<float>(angle(random));
        sample.barrel = stroke.fields.barrel && share(random) < 0.5;
      }
      stroke.samples[5] = stroke.samples[4];  // equal samples stay two
    }
  all[0].strokes[2].samples.resize(1);
  return all;
}

void expect_same(const PenFile& file, const std::vector<Recording>& all) {
  std::size_t number = 0;
  for (const Recording& recording : all)
    for (const RecordedStroke& stroke : recording.strokes) {
      ASSERT_LT(number, file.strokes.size());
      const PenStroke& read = file.strokes[number++];
      EXPECT_EQ(read.fields, stroke.fields);
      EXPECT_EQ(read.drawn_by, stroke.drawn_by);
      EXPECT_EQ(read.has_z, recording.space == StrokeSpace::object);
      ASSERT_EQ(read.samples.size(), stroke.samples.size());
      for (std::size_t i = 0; i < read.samples.size(); ++i)
        ASSERT_TRUE(test::same_bits(read.samples[i], stroke.samples[i])) << number << " " << i;
    }
  EXPECT_EQ(number, file.strokes.size());
}

template <class Write>
PenFile written(const std::vector<Recording>& all, const Write& write) {
  std::ostringstream out;
  write(all, out);
  return test::PenFileFolder().read(out.str());
}

TEST(PenFileWriters, WriteInkmlThatIsReadBackBitForBit) {
  const std::vector<Recording> all = recordings();
  const PenFile file = written(all, write_inkml);
  EXPECT_EQ(file.kind, "inkml");
  expect_same(file, all);
}

TEST(PenFileWriters, WriteNoMoreThanThereIs) {
  std::vector<Recording> all(1);
  all[0].strokes.resize(1);
  all[0].strokes[0].samples.resize(1);
  std::ostringstream csv, inkml;
  write_pen_csv(all, csv);
  EXPECT_EQ(csv.str(), "stroke,x,y,z\n1,0,0,0\n");
  write_inkml(all, inkml);
  EXPECT_EQ(inkml.str().find("brush"), std::string::npos);
}

TEST(PenFileWriters, WriteCsvThatIsReadBackBitForBit) {
  const std::vector<Recording> all = recordings();
  const PenFile file = written(all, write_pen_csv);
  EXPECT_EQ(file.kind, "csv");
  expect_same(file, all);
}

}  // namespace
}  // namespace burin
