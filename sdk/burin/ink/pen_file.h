#pragma once
#include <burin/stroke/recording.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// Adds the fields of further samples to those of their stroke. The button may be told of here and there.
/// Returns false, and leaves the fields, if any other one differs.
inline bool join_fields(PenFields& fields, const PenFields& further) {
  PenFields joined = further;
  joined.barrel = fields.barrel;
  if (joined != fields) return false;
  fields.barrel |= further.barrel;
  return true;
}

/// One stroke of a pen file. What the file does not have is absent, never a neutral value that somebody could
/// take for a measured one.
struct PenStroke {
  PenFields fields;    ///< what `samples` have beside x and y
  bool has_z = false;  ///< lies in space; else z is 0
  DrawnBy drawn_by = {};
  bool made_pressure = false;  ///< the program made the pressure from the speed; no device measured it
  bool estimated_y = false;  ///< lies beside typed text, whose lines have heights that the file does not tell
  std::size_t page = 1, layer = 1;  ///< from 1
  /// Positions in PenFile::unit; in a plane y down, in space y up and z towards the viewer. Times in seconds,
  /// from any start, up to those of 1970. Tilts in radians from upright, towards +x and +y. Pressure 0..1.
  std::vector<Sample> samples;
  std::vector<float> widths;  ///< drawn width by sample, in PenFile::unit; empty if absent
};

/// What a pen file holds: the samples as recorded, in the order of the file.
struct PenFile {
  std::string_view kind;     ///< PenFileKind::name
  std::string device;        ///< as the file names it; empty if it does not
  std::string unit;          ///< of positions: "mm", "px", "pt" (1/72 inch), "dm"; empty if unknown
  double millimetres = 0;    ///< that a unit stands for; 0 if unknown
  std::size_t hovering = 0;  ///< samples left out since the pen did not touch
  /// What is not used: names of the columns of CSV that are not known, in the file's order, or of the
  /// elements of SVG and Xournal++ that are no strokes, sorted.
  std::vector<std::string> not_used;
  std::vector<PenStroke> strokes;
};

/// In what pieces a long file is read, bytes. Others than these are for tests.
struct PenFilePieces {
  std::size_t head = std::size_t{1} << 20;   ///< the beginning, by which its kind is known
  std::size_t block = std::size_t{1} << 18;  ///< each further piece, at least
};

/// A file in memory, or the beginning of a long one of a kind that is read piece by piece.
struct PenFileText {
  std::filesystem::path path;  ///< for messages, and for files beside it
  std::string text;            ///< unpacked
  /// The byte of the file behind `text` if the file goes on; 0 if `text` is all.
  std::uintmax_t rest_at = 0;
  PenFilePieces pieces = {};
};

/// A kind of pen file.
struct PenFileKind {
  std::string_view name;   ///< "inkml"
  std::string_view about;  ///< for people, "InkML"
  /// Whether the text begins like one. Looks at the beginning only, and never at the name.
  bool (*recognises)(std::string_view text);
  /// Throws FileError that names the place: a line, or an element.
  PenFile (*read)(const PenFileText& file);
  bool by_pieces = false;  ///< `read` takes the beginning of a file too
};

/// All kinds, in the order in which a file is compared with them.
std::vector<PenFileKind> pen_file_kinds();

/// Reads the bytes of a pen file, unpacking gzip, xz and the zip of Xournal++; Tilt Brush has folders too.
/// Of a long file that is read piece by piece the text is only the beginning. Throws FileError if it cannot
/// be read, unpacks to more than most_unpacked_bytes(), has more than 60 MB of XML or more than 1 GiB.
PenFileText open_pen_file(const std::filesystem::path& path, const PenFilePieces& pieces = {});

/// The same with all of the text.
PenFileText whole_pen_file(const std::filesystem::path& path);

/// Reads a pen file of any kind, or of the kind with this name whatever its first bytes. Throws FileError for
/// a file that is none or is malformed.
PenFile read_pen_file(const PenFileText& file, std::string_view kind = {});

/// Opens a pen file and reads it.
PenFile read_pen_file(const std::filesystem::path& path);

/// The name of the kind that read_pen_file() would take the file for, or an empty one.
std::string_view kind_of_pen_file(const PenFileText& file);

}  // namespace burin
