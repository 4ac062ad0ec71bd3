#include <burin/ink/parse/text_window.h>

#include "ink/pen_files.h"

namespace burin {
namespace {

/// Lines of numbers, of more than a window has.
std::string many_lines() {
  std::string text;
  for (int i = 0; i < 300'000; ++i) text += std::to_string(i) + (i % 1000 == 0 ? "\n\n" : "\n");
  return text;
}

TEST(TextWindow, HasTheSameLinesOfAFileAsOfAText) {
  const test::PenFileFolder folder;
  const std::string text = many_lines();
  for (const std::size_t head : {std::size_t{1}, std::size_t{1000}, text.size()}) {
    const std::string mark = "\xEF\xBB\xBF";
    const PenFileText file{folder.write("lines", mark + text), text.substr(0, head), mark.size() + head};
    std::string joined;
    std::size_t longest = 0;
    for (TextWindow window(file); !window.text().empty() || window.grow();) {
      EXPECT_EQ(window.place(), joined.size());
      joined.append(window.take_line()) += '\n';
      longest = std::max(longest, window.text().size());
    }
    EXPECT_TRUE(joined == text);
    EXPECT_LT(longest, 600'000u) << "no more than a few blocks are in memory";
  }
}

TEST(TextWindow, GoesToAnyByteOfAFile) {
  const test::PenFileFolder folder;
  const std::string text = many_lines();
  const PenFileText file{folder.write("lines", text), text.substr(0, 10), 10};
  TextWindow window(file);
  for (const std::size_t place :
       {std::size_t{0}, std::size_t{5}, text.size() - 7, std::size_t{5}, text.size()}) {
    window.go_to(place);
    EXPECT_EQ(window.take_line(), text.substr(place, text.find('\n', place) - place));
  }
  EXPECT_EQ(line_of(file, 0), 1u);
  EXPECT_EQ(line_of(file, text.size() - 1), 300'300u);
}

// Wherever a piece of the file ends, also between the two characters of a line end.
TEST(TextWindow, EndsLinesAtLineFeedsAndCarriageReturns) {
  const test::PenFileFolder folder;
  const std::string text = "a\rbc\r\n\n\r\rd\r\n\r\ne";
  const std::vector<std::string> expected = {"a", "bc", "", "", "", "d", "", "e"};
  for (std::size_t head = 1; head <= text.size(); ++head)
    for (std::size_t block = 1; block < 5; ++block) {
      const PenFileText file{folder.write("lines", text),
                             text.substr(0, head),
                             head < text.size() ? head : 0,
                             {.head = head, .block = block}};
      std::vector<std::string> lines;
      for_each_line_of(file, [&](std::string_view line) { lines.emplace_back(line); });
      EXPECT_EQ(lines, expected) << head << " and " << block;
    }
}

/// Texts of more than the beginning by which a kind is known, of 20,000 samples or more.
std::string long_csv() {
  std::string text = "\xEF\xBB\xBFx,y,note\n";
  for (int i = 0; i < 30'000; ++i)
    text += std::to_string(i) + ",1,something that makes the line long enough\n";
  return text;
}

std::string long_pointers() {
  std::string text = "{\"strokes\": [";
  for (int i = 0; i < 30'000; ++i)
    text += std::string(i == 0 ? "" : ", ") + "{\"points\": [{\"x\": " + std::to_string(i) + ", \"y\": 1}]}";
  return text + "]}";
}

std::string long_brush_strokes() {
  std::string text = "f(stroke=[";
  for (int i = 0; i < 30'000; ++i)
    text += "{'name': '', 'location': (0, 0, 0), 'mouse': (" + std::to_string(i) + ", 1)},\n";
  return text + "])\n";
}

/// Of many lists, each of which is read again since it has no places of a mouse.
std::string many_brush_strokes() {
  std::string text;
  for (int i = 0; i < 30'000; ++i)
    text += "f(stroke=[{'name': '', 'location': (" + std::to_string(i) + ", 1, 0), 'size': 1}])\n";
  return text;
}

std::string long_libinput() {
  std::string text = "libinput:\ndevices:\n- evdev:\n    name: A\n  events:\n";
  for (int i = 0; i < 30'000; ++i) {
    const std::string x = std::to_string(i);
    text += "  - evdev:\n    - [0, 0, 3, 0, " + x + "]\n    - [0, 0, 3, 1, 1]\n    - [0, 0, 1, 330, 1]\n";
    text += "    - [0, 0, 0, 0, 0]\n";
    if (i % 100 == 0) text += "  - libinput:\n    - {time: 1}\n";
  }
  return text;
}

// Kinds that are read by pieces keep what lies where a piece ends, and name the line of a fault behind.
TEST(TextWindow, ReadsLongFilesLikeShortOnes) {
  const test::PenFileFolder folder;
  for (const std::string& text :
       {long_csv(), long_pointers(), long_brush_strokes(), many_brush_strokes(), long_libinput()}) {
    ASSERT_GT(text.size(), std::size_t{1} << 20);
    const auto path = folder.write("long", text);
    const PenFileText pieces = open_pen_file(path), whole = whole_pen_file(path);
    EXPECT_NE(pieces.rest_at, 0u);
    EXPECT_EQ(whole.rest_at, 0u);
    const PenFile file = read_pen_file(pieces), expected = read_pen_file(whole);
    ASSERT_EQ(file.strokes.size(), expected.strokes.size());
    std::size_t x = 0;
    for (std::size_t i = 0; i < file.strokes.size(); ++i)
      for (std::size_t k = 0; k < file.strokes[i].samples.size(); ++k, ++x) {
        EXPECT_EQ(file.strokes[i].samples[k].position, expected.strokes[i].samples[k].position);
        EXPECT_EQ(file.strokes[i].samples[k].position.x(), static_cast<double>(x));
      }
    EXPECT_EQ(x, 30'000u);
  }
  EXPECT_EQ(folder.complaint(long_csv() + "1,a\n"), "30002: expected a number, found 'a'");
  EXPECT_EQ(folder.complaint(long_brush_strokes() + "f(stroke=[{'mouse': 1}])").substr(0, 19),
            "30002: element 1: m");
  EXPECT_EQ(folder.complaint(long_libinput() + "  - evdev:\n    - [1]\n").substr(0, 20),
            "150607: an event nee");
}

}  // namespace
}  // namespace burin
