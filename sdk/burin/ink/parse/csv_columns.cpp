// Knows the columns of tables of samples by their names, and the units that these tell.
#include <burin/base/text/lower_case.h>
#include <burin/ink/parse/csv_columns.h>
#include <burin/ink/parse/scan.h>
#include <burin/math/degree.h>

#include <algorithm>
#include <array>
#include <utility>

namespace burin {
namespace {

/// A name that a column may have.
struct Name {
  std::string_view name;  ///< in lower case, blanks as "_"
  CsvCell cell;
  std::string_view unit;  ///< of a column that tells none
};

constexpr std::string_view spline_x = "spline_x";

constexpr std::array names = {
    Name{"x", CsvCell::x, ""}, Name{"y", CsvCell::y, ""}, Name{"z", CsvCell::z, ""},
    Name{"time", CsvCell::time, "s"}, Name{"t", CsvCell::time, "s"},
    Name{"timestamp", CsvCell::time, "no unit"}, Name{"pressure", CsvCell::pressure, ""},
    Name{"p", CsvCell::pressure, ""}, Name{"tilt_x", CsvCell::tilt_x, "rad"},
    Name{"tilt_y", CsvCell::tilt_y, "rad"}, Name{"tiltx", CsvCell::tilt_x, "deg"},
    Name{"tilty", CsvCell::tilt_y, "deg"}, Name{"azimuth", CsvCell::azimuth, "no unit"},
    Name{"altitude", CsvCell::altitude, "no unit"}, Name{"twist", CsvCell::twist, "rad"},
    Name{"contact", CsvCell::contact, ""}, Name{"pen_down", CsvCell::contact, ""},
    Name{"pendown", CsvCell::contact, ""}, Name{"pen_status", CsvCell::contact, ""},
    Name{"penstatus", CsvCell::contact, ""}, Name{"stroke", CsvCell::stroke, ""},
    Name{"stroke_id", CsvCell::stroke, ""}, Name{"strokeid", CsvCell::stroke, ""},
    Name{"eraser", CsvCell::eraser, ""}, Name{"barrel", CsvCell::barrel, ""}, Name{"tool", CsvCell::tool, ""},
    Name{"pointertype", CsvCell::tool, ""},
    // Of Wacom's Universal Ink Library.
    Name{spline_x, CsvCell::x, "px"}, Name{"spline_y", CsvCell::y, "px"},
    Name{"sensor_timestamp", CsvCell::time, "ms"}, Name{"sensor_pressure", CsvCell::pressure, ""},
    Name{"sensor_altitude", CsvCell::altitude, "rad"}, Name{"sensor_azimuth", CsvCell::azimuth, "rad"}};

enum class Measure { length, time, angle, share };

struct ColumnUnit {
  std::string_view name;
  Measure measure;
  double scale;  ///< to millimetres, seconds, radians, or a share of 1
};

constexpr std::array units = {ColumnUnit{"mm", Measure::length, 1},
                              ColumnUnit{"cm", Measure::length, 10},
                              ColumnUnit{"m", Measure::length, 1000},
                              ColumnUnit{"in", Measure::length, 25.4},
                              ColumnUnit{"s", Measure::time, 1},
                              ColumnUnit{"ms", Measure::time, 1e-3},
                              ColumnUnit{"us", Measure::time, 1e-6},
                              ColumnUnit{"\u00b5s", Measure::time, 1e-6},
                              ColumnUnit{"ns", Measure::time, 1e-9},
                              ColumnUnit{"deg", Measure::angle, math::degree},
                              ColumnUnit{"\u00b0", Measure::angle, math::degree},
                              ColumnUnit{"rad", Measure::angle, 1},
                              ColumnUnit{"%", Measure::share, 0.01}};

/// Parts a name as "time_ms", "Time (ms)" and "time [ms]" into the name and its unit, in lower case.
std::pair<std::string, std::string> name_and_unit(std::string_view cell) {
  std::string name = in_lower_case(std::string(cell)), unit;
  const std::size_t open = name.find_first_of("([");
  if (open != name.npos) {
    const std::size_t close = name.find_first_of(")]", open);
    unit = trimmed(std::string_view(name).substr(open + 1, close - open - 1));
    name = trimmed(std::string_view(name).substr(0, open));
  }
  std::ranges::replace(name, ' ', '_');
  const std::size_t mark = name.find_last_of('_');
  if (!unit.empty() || mark == name.npos) return {name, unit};
  const std::string suffix = name.substr(mark + 1);
  if (suffix != "px" && std::ranges::find(units, suffix, &ColumnUnit::name) == units.end()) return {name, ""};
  return {name.substr(0, mark), suffix};
}

/// What a column is by its name. Times and angles of a unit that is not known are left out.
CsvColumn column_of(std::string_view cell) {
  const auto [name, told] = name_and_unit(cell);
  const auto found = std::ranges::find(names, name, &Name::name);
  CsvColumn column{std::string(cell)};
  if (found == names.end()) return column;
  const std::string_view unit = told.empty() ? found->unit : std::string_view(told);
  const auto known = std::ranges::find(units, unit, &ColumnUnit::name);
  const auto in = [&](Measure measure) { return known != units.end() && known->measure == measure; };
  const bool angle = found->cell >= CsvCell::tilt_x && found->cell <= CsvCell::twist;
  if ((found->cell == CsvCell::time && !in(Measure::time)) || (angle && !in(Measure::angle))) return column;
  column.cell = found->cell;
  if (in(Measure::time) || in(Measure::angle) || (column.cell == CsvCell::pressure && in(Measure::share)))
    column.scale = known->scale;
  if (!is_position(column.cell)) return column;
  if (in(Measure::length)) column.scale = known->scale;
  column.unit = in(Measure::length) ? "mm" : unit == "px" ? "px" : "";
  return column;
}

/// Where quotes are closed within which a text is from `begin` on; its size if they are not. Two in a row are
/// one of the cell.
std::size_t end_of_quotes(std::string_view text, std::size_t begin) {
  for (std::size_t i = begin; i < text.size(); ++i) {
    if (text[i] != '"') continue;
    if (!text.substr(i + 1).starts_with('"')) return i;
    ++i;
  }
  return text.size();
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  skip_blanks(text);
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

bool is_position(CsvCell cell) { return cell == CsvCell::x || cell == CsvCell::y || cell == CsvCell::z; }

char csv_separator_of(std::string_view header) {
  for (const char separator : {'\t', ';', ','})
    if (header.find(separator) != header.npos) return separator;
  return ' ';
}

OpenQuotes quotes_behind(std::string_view line, char separator, OpenQuotes before) {
  if (before != OpenQuotes::none) {
    const std::size_t close = end_of_quotes(line, 0);
    if (close == line.size()) return OpenQuotes::before;
    line.remove_prefix(std::min(line.find(separator, close), line.size() - 1) + 1);
  }
  while (!line.empty()) {
    const std::size_t begin = std::min(line.find_first_not_of(" \r"), line.size());
    if (line.substr(begin).starts_with('"') && end_of_quotes(line, begin + 1) == line.size())
      return OpenQuotes::here;
    take_csv_cell(line, separator);
  }
  return OpenQuotes::none;
}

CsvText take_csv_cell(std::string_view& line, char separator) {
  const std::size_t begin = std::min(line.find_first_not_of(" \r"), line.size());
  const bool quoted = line.substr(begin).starts_with('"');
  const std::size_t close = quoted ? end_of_quotes(line, begin + 1) : 0;
  const std::size_t end = std::min(line.find(separator, std::max(begin, close)), line.size());
  const std::string_view cell = quoted ? line.substr(begin + 1, close - begin - 1) : line.substr(0, end);
  line.remove_prefix(std::min(end + 1, line.size()));
  if (separator == ' ') skip_blanks(line);
  return {quoted ? cell : trimmed(cell), quoted};
}

bool is_absent_cell(std::string_view cell) {
  constexpr std::array<std::string_view, 6> words = {"", "nan", "NaN", "NA", "null", "None"};
  return std::ranges::find(words, cell) != words.end();
}

std::vector<CsvColumn> csv_columns_of(std::string_view header) {
  const char separator = csv_separator_of(header);
  std::vector<CsvColumn> named;
  while (!header.empty()) named.push_back(column_of(trimmed(take_csv_cell(header, separator).text)));
  // The Universal Ink Library numbers strokes so; elsewhere an index is that of the row.
  const auto is = [](std::string_view name) {
    return [name](const CsvColumn& column) { return in_lower_case(column.name) == name; };
  };
  const auto index = std::ranges::find_if(named, is("idx"));
  if (index != named.end() && std::ranges::any_of(named, is(spline_x))) index->cell = CsvCell::stroke;
  // One angle without the other tells no tilt.
  for (const auto& [one, other] :
       {std::pair(CsvCell::azimuth, CsvCell::altitude), std::pair(CsvCell::altitude, CsvCell::azimuth)})
    if (std::ranges::find(named, other, &CsvColumn::cell) == named.end())
      for (CsvColumn& column : named)
        if (column.cell == one) column.cell = CsvCell::unknown;
  return named;
}

}  // namespace burin
