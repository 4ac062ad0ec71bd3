// Reads .scap drawings of the research on sketches: "#width height", "@thickness", then strokes in braces,
// each with "#stroke cluster" and lines of "x y pressure". Positions are pixels. Pressures that are whole
// numbers throughout the file are none: 0, or marks of what a point is; of time there is nothing.
#include <burin/base/error.h>
#include <burin/ink/kinds/kinds.h>
#include <burin/ink/no_pressure.h>
#include <burin/ink/parse/scan.h>
#include <burin/ink/parse/text_window.h>
#include <burin/ink/pen_file.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace burin {
namespace {

/// Takes the lines of a file.
class Strokes {
 public:
  explicit Strokes(PenFile& content) : strokes_(content.strokes) {}

  void take(std::string_view line) {
    skip_blanks(line);
    if (line.empty() || line.front() == '#' || line.front() == '@') return;
    if (line.front() == '{') {
      if (open_) throw Error("a stroke within a stroke");
      open_ = true;
      strokes_.emplace_back().fields.pressure = true;
    } else if (line.front() == '}') {
      if (!open_) throw Error("'}' without '{'");
      open_ = false;
    } else {
      take_point(line);
    }
  }

 private:
  void take_point(std::string_view line) {
    double x = 0, y = 0, pressure = 0;
    const auto take_next = [&line](double& value) {
      skip_blanks(line);
      return take_number(line, value);
    };
    if (!take_next(x) || !take_next(y) || !take_next(pressure))
      throw Error("expected three numbers: x y pressure");
    if (!open_) throw Error("a point outside a stroke");
    Sample& sample = strokes_.back().samples.emplace_back();
    sample.position = {x, y, 0};
    sample.pen.pressure = static_cast<float>(pressure);
  }

  std::vector<PenStroke>& strokes_;
  bool open_ = false;
};

void drop_void_pressure(std::vector<PenStroke>& strokes) {
  if (!greatest_whole_pressure(strokes)) return;
  for (PenStroke& stroke : strokes) leave_out_pressure(stroke);
}

}  // namespace

bool is_scap(std::string_view text) {
  skip_blanks(text);
  double width = 0, height = 0;
  if (!text.starts_with('#')) return false;
  text.remove_prefix(1);
  if (!take_number(text, width)) return false;
  skip_blanks(text);
  if (!take_number(text, height)) return false;
  skip_blanks(text);
  return text.starts_with('@');
}

PenFile read_scap(const PenFileText& file) {
  PenFile content;
  content.unit = "px";
  Strokes strokes(content);
  for_each_line_of(file, [&](std::string_view line) { strokes.take(line); });
  std::erase_if(content.strokes, [](const PenStroke& stroke) { return stroke.samples.empty(); });
  drop_void_pressure(content.strokes);
  return content;
}

}  // namespace burin
