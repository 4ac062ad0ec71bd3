// Reads CSV whose first line names the columns, as write_pen_csv() does and as spreadsheets and recorders of
// all sorts do. Columns part by commas, semicolons or tabs. x and y must be there; the names that are known
// are in `columns` below, others are left out. An empty cell is absent. Lines that begin with '#' are
// comments; the first line may begin so too, as NumPy writes it.
#include <burin/base/error.h>
#include <burin/base/quoted_word.h>
#include <burin/base/text/lower_case.h>
#include <burin/ink/kinds/kinds.h>
#include <burin/ink/parse/scan.h>
#include <burin/ink/pen_file.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace burin {
namespace {

constexpr double degree = std::numbers::pi / 180;

enum class Cell { x, y, z, time, pressure, tilt_x, tilt_y, twist, contact, stroke, eraser, unknown };

struct Column {
  std::string_view name;
  Cell cell;
  double scale;  ///< to seconds, radians
};

constexpr std::array columns = {Column{"x", Cell::x, 1},
                                Column{"y", Cell::y, 1},
                                Column{"z", Cell::z, 1},
                                Column{"time", Cell::time, 1},
                                Column{"t", Cell::time, 1},
                                Column{"time_s", Cell::time, 1},
                                Column{"time_ms", Cell::time, 1e-3},
                                Column{"t_ms", Cell::time, 1e-3},
                                Column{"time_us", Cell::time, 1e-6},
                                Column{"pressure", Cell::pressure, 1},
                                Column{"p", Cell::pressure, 1},
                                Column{"tilt_x", Cell::tilt_x, 1},
                                Column{"tilt_y", Cell::tilt_y, 1},
                                Column{"tilt_x_deg", Cell::tilt_x, degree},
                                Column{"tilt_y_deg", Cell::tilt_y, degree},
                                Column{"tiltx", Cell::tilt_x, degree},
                                Column{"tilty", Cell::tilt_y, degree},
                                Column{"twist", Cell::twist, 1},
                                Column{"twist_deg", Cell::twist, degree},
                                Column{"contact", Cell::contact, 1},
                                Column{"pen_down", Cell::contact, 1},
                                Column{"stroke", Cell::stroke, 1},
                                Column{"stroke_id", Cell::stroke, 1},
                                Column{"eraser", Cell::eraser, 1}};

std::string_view trimmed(std::string_view text) {
  skip_blanks(text);
  text = text.substr(0, text.find_last_not_of(blanks) + 1);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
  return text;
}

char separator_of(std::string_view header) {
  for (const char separator : {'\t', ';'})
    if (header.find(separator) != header.npos) return separator;
  return ',';
}

/// Calls `take` with each cell of a line and its number.
template <class Take>
void for_each_cell(std::string_view line, char separator, const Take& take) {
  for (std::size_t number = 0;; ++number) {
    const std::size_t end = line.find(separator);
    take(trimmed(line.substr(0, end)), number);
    if (end == line.npos) return;
    line.remove_prefix(end + 1);
  }
}

/// The columns that a first line names, which must outlive them.
std::vector<Column> columns_of(std::string_view header) {
  std::vector<Column> named;
  for_each_cell(header, separator_of(header), [&](std::string_view cell, std::size_t) {
    const std::string name = in_lower_case(std::string(cell));
    const auto found = std::ranges::find(columns, name, &Column::name);
    named.push_back(found == columns.end() ? Column{cell, Cell::unknown, 1} : *found);
  });
  return named;
}

bool has(std::span<const Column> named, Cell cell) {
  return std::ranges::find(named, cell, &Column::cell) != named.end();
}

constexpr char comment_mark = '#';

/// The columns of a line that names x and y; none for other lines.
std::vector<Column> header_columns(std::string_view line) {
  if (line.starts_with(comment_mark)) line.remove_prefix(1);
  if (line.find_first_of(",;\t") == line.npos) return {};
  std::vector<Column> named = columns_of(line);
  return has(named, Cell::x) && has(named, Cell::y) ? named : std::vector<Column>();
}

/// A line of the table.
struct Row {
  Sample sample;
  PenFields fields;
  bool has_x = false, has_y = false, has_z = false, contact = true, eraser = false;
  double stroke = 0;
};

void set(Row& row, Cell cell, double value) {
  Sample& sample = row.sample;
  const auto small = static_cast<float>(value);
  switch (cell) {
    case Cell::x:
      sample.position.x() = value;
      row.has_x = true;
      break;
    case Cell::y:
      sample.position.y() = value;
      row.has_y = true;
      break;
    case Cell::z:
      sample.position.z() = value;
      row.has_z = true;
      break;
    case Cell::time:
      sample.time = value;
      row.fields.time = true;
      break;
    case Cell::pressure:
      sample.pen.pressure = small;
      row.fields.pressure = true;
      break;
    case Cell::tilt_x:
      sample.pen.tilt_x = small;
      row.fields.tilt = true;
      break;
    case Cell::tilt_y:
      sample.pen.tilt_y = small;
      row.fields.tilt = true;
      break;
    case Cell::twist:
      sample.pen.twist = small;
      row.fields.twist = true;
      break;
    case Cell::contact:
      row.contact = value != 0;
      break;
    case Cell::stroke:
      row.stroke = value;
      break;
    case Cell::eraser:
      row.eraser = value != 0;
      break;
    case Cell::unknown:
      break;
  }
}

Row row_of(std::string_view line, char separator, std::span<const Column> named) {
  Row row;
  for_each_cell(line, separator, [&](std::string_view cell, std::size_t number) {
    if (number >= named.size()) throw Error(fmt::format("a line of more than the {} columns", named.size()));
    if (named[number].cell == Cell::unknown || cell.empty()) return;
    double value = 0;
    if (!take_number(cell, value) || !cell.empty())
      throw Error(fmt::format("expected a number, found {}", quoted_word(cell)));
    set(row, named[number].cell, named[number].scale == 1 ? value : value * named[number].scale);
  });
  if (!row.has_x || !row.has_y) throw Error("a line without x or y");
  return row;
}

/// Makes strokes of rows: one for each run of one number in the column `stroke` in which the pen touches.
class Rows {
 public:
  void take(const Row& row) {
    if (!row.contact) {
      ++content_.hovering;
      down_ = false;
      return;
    }
    if (!down_ || row.stroke != stroke_) {
      PenStroke& stroke = content_.strokes.emplace_back();
      stroke.fields = row.fields;
      stroke.has_z = row.has_z;
      stroke.eraser = row.eraser;
    }
    down_ = true;
    stroke_ = row.stroke;
    PenStroke& stroke = content_.strokes.back();
    if (row.fields != stroke.fields) throw Error("a line has other cells than the first of its stroke");
    stroke.samples.push_back(row.sample);
  }
  PenFile finish() { return std::move(content_); }

 private:
  PenFile content_;
  bool down_ = false;
  double stroke_ = 0;
};

}  // namespace

bool is_csv(std::string_view text) {
  constexpr std::size_t early = 4096;
  text = text.substr(0, early);
  for (;;) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    if (!header_columns(line).empty()) return true;
    if (!line.starts_with(comment_mark) || end == text.npos) return false;
    text.remove_prefix(end + 1);
  }
}

PenFile read_csv(const PenFileText& file) {
  std::vector<Column> named;
  char separator = ',';
  Rows rows;
  for_each_line_of(file.text, file.path.string(), [&](std::string_view line) {
    if (line.find_first_not_of(blanks) == line.npos) return;
    if (named.empty()) {
      named = header_columns(line);
      separator = separator_of(line);
      if (named.empty() && !line.starts_with(comment_mark)) throw Error("names no columns x and y");
    } else if (!line.starts_with(comment_mark)) {
      rows.take(row_of(line, separator, named));
    }
  });
  PenFile content = rows.finish();
  for (const Column& column : named)
    if (column.cell == Cell::unknown) content.not_used.emplace_back(column.name);
  return content;
}

}  // namespace burin
