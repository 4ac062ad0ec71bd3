#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// What a column of a table of samples has.
enum class CsvCell {
  x,
  y,
  z,
  time,
  pressure,
  tilt_x,
  tilt_y,
  azimuth,
  altitude,
  twist,
  contact,
  stroke,
  eraser,
  barrel,
  tool,
  unknown
};

/// A column as its name tells it.
struct CsvColumn {
  std::string name;  ///< as the file has it
  CsvCell cell = CsvCell::unknown;
  double scale = 1;       ///< to millimetres, seconds, radians, or a share of 1
  std::string unit = {};  ///< of positions, as PenFile::unit
};

bool is_position(CsvCell cell);

/// Without blanks at the ends.
std::string_view trimmed(std::string_view text);

/// What parts the cells of the lines of a table, by the one that names its columns.
char csv_separator_of(std::string_view header);

/// Quotes around a cell that are not closed at the end of a line, so that the next one belongs to it: whether
/// the line opens them, or one before it.
enum class OpenQuotes { none, here, before };

/// Those behind a line. `before`: those behind the line before it.
OpenQuotes quotes_behind(std::string_view line, char separator, OpenQuotes before);

/// The text of a cell of a line.
struct CsvText {
  std::string_view text;  ///< without blanks at its ends, or what is between quotes, with all that is there
  bool quoted = false;
};

/// Removes the next cell and its separator from the front of a line. Quotes around a cell keep separators in
/// it, and are removed.
CsvText take_csv_cell(std::string_view& line, char separator);

/// Whether a cell is empty, or has one of the words by which tables tell that it is.
bool is_absent_cell(std::string_view cell);

/// The columns that a line names.
std::vector<CsvColumn> csv_columns_of(std::string_view header);

}  // namespace burin
