// Reads CSV whose first line names the columns, as write_pen_csv() does and as spreadsheets and recorders of
// all sorts do. Columns part by commas, semicolons, tabs or, where all names are known, blanks. x and y must
// be there; the names that are known are in parse/csv_columns.cpp, others are left out. A name may have a
// unit: "time_ms", "x (mm)". An empty cell is absent. Lines that begin with '#' are comments; the first line
// may begin so too, as NumPy writes it.
#include <burin/base/error.h>
#include <burin/base/text/lower_case.h>
#include <burin/base/text/quoted_word.h>
#include <burin/ink/decode/tilt_angles.h>
#include <burin/ink/kinds/kinds.h>
#include <burin/ink/no_pressure.h>
#include <burin/ink/parse/csv_columns.h>
#include <burin/ink/parse/iso_time.h>
#include <burin/ink/parse/scan.h>
#include <burin/ink/parse/text_window.h>
#include <burin/ink/pen_file.h>
#include <burin/math/degree.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace burin {
namespace {

bool has(std::span<const CsvColumn> named, CsvCell cell) {
  return std::ranges::find(named, cell, &CsvColumn::cell) != named.end();
}

constexpr char comment_mark = '#';

/// Whether a line may stand before the one that names the columns: a comment, or what Excel wants to be told.
bool may_come_first(std::string_view line) {
  return line.starts_with(comment_mark) || line.starts_with("sep=") ||
         line.find_first_not_of(blanks) == line.npos;
}

/// The columns of a line that names x and y; none for other lines.
std::vector<CsvColumn> header_columns(std::string_view line) {
  if (line.starts_with(comment_mark)) line.remove_prefix(1);
  std::vector<CsvColumn> named = csv_columns_of(line);
  if (!has(named, CsvCell::x) || !has(named, CsvCell::y)) return {};
  // Between blanks any text has names.
  if (csv_separator_of(line) == ' ' && has(named, CsvCell::unknown)) return {};
  return named;
}

/// A line of the table.
struct Row {
  Sample sample;
  PenFields fields;
  bool has_x = false, has_y = false, has_z = false, contact = true, eraser = false;
  std::optional<double> azimuth, altitude;  ///< from +x towards +y, and above the plane, radians
  double stroke = 0;
  std::string_view stroke_name;  ///< where that is no number; empty else
  std::string_view tool;         ///< quotes in it are doubled
};

void set(Row& row, CsvCell cell, double value) {
  Sample& sample = row.sample;
  const auto small = static_cast<float>(value);
  switch (cell) {
    case CsvCell::x:
      sample.position.x() = value;
      row.has_x = true;
      break;
    case CsvCell::y:
      sample.position.y() = value;
      row.has_y = true;
      break;
    case CsvCell::z:
      sample.position.z() = value;
      row.has_z = true;
      break;
    case CsvCell::time:
      sample.time = value;
      row.fields.time = true;
      break;
    case CsvCell::pressure:
      sample.pen.pressure = small;
      row.fields.pressure = true;
      break;
    case CsvCell::tilt_x:
      sample.pen.tilt_x = small;
      row.fields.tilt = true;
      break;
    case CsvCell::tilt_y:
      sample.pen.tilt_y = small;
      row.fields.tilt = true;
      break;
    case CsvCell::azimuth:
      row.azimuth = value;
      break;
    case CsvCell::altitude:
      row.altitude = value;
      break;
    case CsvCell::twist:
      sample.pen.twist = small;
      row.fields.twist = true;
      break;
    case CsvCell::contact:
      row.contact = value != 0;
      break;
    case CsvCell::stroke:
      row.stroke = value;
      break;
    case CsvCell::eraser:
      row.eraser = value != 0;
      break;
    case CsvCell::barrel:
      sample.barrel = value != 0;
      row.fields.barrel = true;
      break;
    case CsvCell::tool:
    case CsvCell::unknown:
      break;
  }
}

/// The value of a cell, or nothing for an empty one and what tables have for one. Where a comma does not part
/// cells, it may part the decimals of a number.
std::optional<double> value_of(std::string_view cell) {
  std::string_view rest = cell;
  double value = 0;
  if (take_number(rest, value) && rest.empty()) return value;
  if (is_absent_cell(cell)) return std::nullopt;
  std::string word = in_lower_case(std::string(cell));
  if (word == "true" || word == "false") return word == "true" ? 1 : 0;
  std::ranges::replace(word, ',', '.');
  rest = word;
  if (!take_number(rest, value) || !rest.empty())
    throw Error(fmt::format("expected a number, found {}", quoted_word(cell)));
  return value;
}

bool is_number(std::string_view cell) {
  double value = 0;
  return take_number(cell, value) && cell.empty();
}

Row row_of(std::string_view line, char separator, std::span<const CsvColumn> named) {
  Row row;
  for (std::size_t number = 0; !line.empty(); ++number) {
    const CsvText text = take_csv_cell(line, separator);
    const std::string_view cell = trimmed(text.text);
    if (number >= named.size()) throw Error(fmt::format("a line of more than the {} columns", named.size()));
    if (named[number].cell == CsvCell::unknown) continue;
    if (named[number].cell == CsvCell::stroke && !is_number(cell))
      row.stroke_name = cell;
    else if (named[number].cell == CsvCell::tool)
      row.tool = text.quoted ? text.text : is_absent_cell(cell) ? std::string_view() : cell;
    else if (const auto time = named[number].cell == CsvCell::time ? iso_time(cell) : std::nullopt)
      set(row, CsvCell::time, *time);
    else if (const auto value = value_of(cell))
      set(row, named[number].cell, *value * named[number].scale);
  }
  if (!row.has_x || !row.has_y) throw Error("a line without x or y");
  if (row.azimuth && row.altitude && !row.fields.tilt) {
    row.fields.tilt = true;
    set_tilt(row.sample.pen, *row.azimuth, *row.altitude);
  }
  return row;
}

/// The text of a cell in which quotes are doubled.
std::string unquoted(std::string_view cell) {
  std::string text;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    text += cell[i];
    if (cell.substr(i).starts_with("\"\"")) ++i;
  }
  return text;
}

/// Makes strokes of rows: one for each run of one number, or one text, in the column `stroke` in which one
/// tool touches with one end.
class Rows {
 public:
  void take(const Row& row) {
    if (!row.contact) {
      ++content_.hovering;
      down_ = false;
      return;
    }
    if (!goes_on(row)) begin(row);
    PenStroke& stroke = content_.strokes.back();
    if (!join_fields(stroke.fields, row.fields))
      throw Error("a line has other cells than the first of its stroke");
    stroke.samples.push_back(row.sample);
  }
  /// Leaves out pressures that are whole numbers of a device, up to more than 1, whose range nothing tells.
  /// Returns whether they are.
  bool drop_pressure_without_range();
  /// Takes tilts of no told unit for degrees if some are more than a turn in radians. Returns false, and
  /// leaves them out, if they are more than degrees can be.
  bool settle_tilts();
  PenFile finish() { return std::move(content_); }

 private:
  bool goes_on(const Row& row) const {
    return down_ && row.stroke == stroke_ && row.stroke_name == stroke_name_ && row.tool == tool_ &&
           row.eraser == content_.strokes.back().drawn_by.eraser;
  }

  void begin(const Row& row) {
    PenStroke& stroke = content_.strokes.emplace_back();
    stroke.fields = row.fields;
    stroke.has_z = row.has_z;
    stroke.drawn_by = {unquoted(row.tool), row.eraser};
    down_ = true;
    stroke_ = row.stroke;
    stroke_name_ = row.stroke_name;
    tool_ = row.tool;
  }

  PenFile content_;
  bool down_ = false;
  double stroke_ = 0;
  std::string stroke_name_, tool_;  ///< as the open stroke's cells have them
};

bool Rows::drop_pressure_without_range() {
  const std::optional<float> most = greatest_whole_pressure(content_.strokes);
  if (!most || *most <= 1) return false;
  for (PenStroke& stroke : content_.strokes) leave_out_pressure(stroke);
  return true;
}

bool Rows::settle_tilts() {
  constexpr float right_angle = 90, turn_in_radians = static_cast<float>(360 * math::degree);
  float most = 0;
  for (const PenStroke& stroke : content_.strokes)
    for (const Sample& sample : stroke.samples)
      most = std::max({most, std::abs(sample.pen.tilt_x), std::abs(sample.pen.tilt_y)});
  if (most <= turn_in_radians) return true;
  const float by = most <= right_angle ? static_cast<float>(math::degree) : 0;
  for (PenStroke& stroke : content_.strokes) {
    stroke.fields.tilt &= by > 0;
    for (Sample& sample : stroke.samples) {
      sample.pen.tilt_x *= by;
      sample.pen.tilt_y *= by;
    }
  }
  return by > 0;
}

/// Whether a column is of tilts, in radians only since its name tells no unit.
bool is_tilt_of_no_unit(const CsvColumn& column) {
  return (column.cell == CsvCell::tilt_x || column.cell == CsvCell::tilt_y) && column.scale == 1 &&
         in_lower_case(column.name).find("rad") == std::string::npos;
}

/// Puts rows together whose cells have line ends in quotes.
class QuotedRows {
 public:
  explicit QuotedRows(const std::filesystem::path& path) : path_(path) {}

  /// Takes the next line of the file. Returns whether it ends a row, which is then `line`. Throws FileError
  /// for quotes that are not closed within 1 MB, and names the line that opens them.
  bool take(std::string_view& line, char separator, std::size_t number) {
    const bool joined = within();
    if (!joined && line.starts_with(comment_mark)) return true;
    if (joined)
      row_ += '\n';
    else
      row_.clear();
    open_ = quotes_behind(line, separator, open_);
    if (open_ == OpenQuotes::here) opened_at_ = number;
    if (!joined && !within()) return true;
    row_ += line;
    line = row_;
    constexpr std::size_t longest = 1'000'000;
    if (row_.size() > longest) reject("opens quotes that are not closed within 1 MB");
    return !within();
  }

  bool within() const { return open_ != OpenQuotes::none; }

  void finish() const {
    if (within()) reject("opens quotes that are not closed");
  }

 private:
  [[noreturn]] void reject(std::string_view what) const {
    throw FileError(path_.string(), std::to_string(opened_at_), what);
  }

  const std::filesystem::path& path_;
  std::string row_;  ///< what is there of it
  OpenQuotes open_ = OpenQuotes::none;
  std::size_t opened_at_ = 0;
};

}  // namespace

bool is_csv(std::string_view text) {
  constexpr std::size_t early = 4096;
  text = text.substr(0, early);
  // Names of members of JSON can be those of columns.
  const std::size_t first = text.find_first_not_of(blanks);
  if (first != text.npos && (text[first] == '{' || text[first] == '[')) return false;
  for (;;) {
    const std::size_t end = text.find_first_of("\r\n");
    const std::string_view line = text.substr(0, end);
    if (!header_columns(line).empty()) return true;
    if (!may_come_first(line) || end == text.npos) return false;
    text.remove_prefix(end + 1);
  }
}

PenFile read_csv(const PenFileText& file) {
  std::vector<CsvColumn> named;
  char separator = ',';
  Rows rows;
  QuotedRows quoted(file.path);
  std::size_t number = 0;
  for_each_line_of(file, [&](std::string_view line) {
    ++number;
    if (!quoted.within() && line.find_first_not_of(blanks) == line.npos) return;
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (named.empty()) {
      named = header_columns(line);
      separator = csv_separator_of(line);
      if (named.empty() && !may_come_first(line)) throw Error("names no columns x and y");
    } else if (quoted.take(line, separator, number) && !line.starts_with(comment_mark)) {
      rows.take(row_of(line, separator, named));
    }
  });
  quoted.finish();
  const bool no_range = rows.drop_pressure_without_range();
  const bool no_tilts = std::ranges::any_of(named, is_tilt_of_no_unit) && !rows.settle_tilts();
  PenFile content = rows.finish();
  for (const CsvColumn& column : named) {
    if (column.cell == CsvCell::unknown || (no_range && column.cell == CsvCell::pressure) ||
        (no_tilts && is_tilt_of_no_unit(column)))
      content.not_used.push_back(column.name);
    if (is_position(column.cell)) content.unit = column.unit;
  }
  if (content.unit == "mm") content.millimetres = 1;
  return content;
}

}  // namespace burin
