// Finds the kind of a pen file by its first bytes, and has it read.
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/base/text/utf8.h>
#include <burin/ink/kinds/kinds.h>
#include <burin/ink/parse/unpack.h>
#include <burin/ink/parse/utf16.h>
#include <burin/ink/pen_file.h>
#include <burin/stroke/files/recording_faults.h>
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <utility>

namespace burin {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

template <class Is>
std::optional<PenFileKind> first_kind(const Is& is) {
  const std::vector<PenFileKind> kinds = pen_file_kinds();
  const auto found = std::ranges::find_if(kinds, is);
  return found == kinds.end() ? std::nullopt : std::optional(*found);
}

std::optional<PenFileKind> kind_of(std::string_view text) {
  return first_kind([&](const PenFileKind& kind) { return kind.recognises(text); });
}

std::optional<PenFileKind> kind_named(std::string_view name) {
  return first_kind([&](const PenFileKind& kind) { return kind.name == name; });
}

/// The beginning of a long file of a kind that is read piece by piece; nothing of others, and of those that
/// must be unpacked.
std::optional<PenFileText> opened_by_pieces(const std::filesystem::path& path, const PenFilePieces& pieces) {
  constexpr std::uintmax_t most_bytes = std::uintmax_t{1} << 30;
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error || size <= pieces.head) return std::nullopt;
  PenFileText file{path, std::string(pieces.head, '\0'), pieces.head, pieces};
  std::ifstream in(path, std::ios::binary);
  in.read(file.text.data(), static_cast<std::streamsize>(pieces.head));
  if (!in || is_packed(file.text) || is_utf16(file.text)) return std::nullopt;
  if (file.text.starts_with(byte_order_mark)) file.text.erase(0, byte_order_mark.size());
  const std::optional<PenFileKind> kind = kind_of(file.text);
  if (!kind || !kind->by_pieces) return std::nullopt;
  if (size > most_bytes) throw FileError(path.string(), "holds more than 1073741824 bytes");
  return file;
}

/// Whether times of a kind count from any moment; others count from when a device, a program or 1970 began.
bool has_times_from_anywhere(const PenFile& content) {
  return content.kind == "csv" || content.kind == "inkml";
}

/// Refuses names of tools that no text of JSON or XML can have.
void check_tools(const PenFileText& file, const PenFile& content) {
  const auto is_text = [](const PenStroke& stroke) { return is_utf8(stroke.drawn_by.tool); };
  const auto other = std::ranges::find_if_not(content.strokes, is_text);
  if (other != content.strokes.end())
    throw FileError(file.path.string(), fmt::format("stroke {}: the name of the tool is not valid UTF-8",
                                                    other - content.strokes.begin() + 1));
}

/// Refuses what no sample may have.
void check(const PenFileText& file, const PenFile& content) {
  for (std::size_t stroke = 0; stroke < content.strokes.size(); ++stroke)
    for (std::size_t i = 0; i < content.strokes[stroke].samples.size(); ++i) {
      const Sample& sample = content.strokes[stroke].samples[i];
      const bool negative =
          content.strokes[stroke].fields.time && sample.time < 0 && !has_times_from_anywhere(content);
      const std::string_view fault = negative ? "time is negative" : validation_error(sample);
      if (!fault.empty())
        throw FileError(file.path.string(),
                        fmt::format("stroke {}, sample {}: {}", stroke + 1, i + 1, fault));
    }
}

}  // namespace

std::vector<PenFileKind> pen_file_kinds() {
  return {{"uim", "Universal Ink Model", is_uim, read_uim},
          {"uim_json", "Universal Ink Model in JSON", is_uim_json, read_uim_json, true},
          {"will", "WILL", is_will, read_will},
          {"tilt", "Tilt Brush", is_tilt, read_tilt},
          {"isf", "Ink Serialized Format", is_isf, read_isf},
          {"remarkable", "reMarkable lines", is_remarkable, read_remarkable},
          {"excalidraw", "Excalidraw", is_excalidraw, read_excalidraw, true},
          {"scap", "scap drawings", is_scap, read_scap, true},
          {"inkml", "InkML", is_inkml, read_inkml},
          {"xournal", "Xournal and Xournal++", is_xournal, read_xournal},
          {"svg", "SVG paths", is_svg, read_svg},
          {"evemu", "EVEMU recordings", is_evemu, read_evemu, true},
          {"hid", "hid-recorder", is_hid, read_hid, true},
          {"libinput", "libinput record", is_libinput, read_libinput, true},
          {"pointers", "lists of pointers from the web", is_pointers, read_pointers, true},
          {"brush_stroke", "Blender's brush strokes", is_brush_strokes, read_brush_strokes, true},
          {"pointer", "PointerEvent arrays", is_pointer_arrays, read_pointer_arrays, true},
          {"svc", "SVC", is_svc, read_svc, true},
          {"mypaint", "libmypaint events", is_mypaint, read_mypaint, true},
          {"point_lists", "named lists of points", is_point_lists, read_point_lists, true},
          {"csv", "CSV with named columns", is_csv, read_csv, true}};
}

PenFileText open_pen_file(const std::filesystem::path& path, const PenFilePieces& pieces) {
  if (auto file = opened_by_pieces(path, pieces)) return std::move(*file);
  return whole_pen_file(path);
}

PenFileText whole_pen_file(const std::filesystem::path& path) {
  PenFileText file{path, unpacked_pen_file(path)};
  if (file.text.starts_with(byte_order_mark)) file.text.erase(0, byte_order_mark.size());
  auto text = from_utf16(file.text);
  if (text) file.text = std::move(*text);
  // UTF-8 may be longer than UTF-16.
  if (text && file.text.size() > most_parsed_bytes)
    throw FileError(path.string(), "more than 60 MB of XML, JSON or UTF-16");
  return file;
}

PenFile read_pen_file(const std::filesystem::path& path) { return read_pen_file(open_pen_file(path)); }

PenFile read_pen_file(const PenFileText& file, std::string_view name) {
  const std::optional<PenFileKind> kind = name.empty() ? kind_of(file.text) : kind_named(name);
  if (!kind) {
    std::string known;
    for (const PenFileKind& one : pen_file_kinds())
      known += fmt::format("{}{}", known.empty() ? "" : ", ", one.about);
    throw FileError(file.path.string(), fmt::format("no pen file that is known; known are {}", known));
  }
  if (file.rest_at != 0 && !kind->by_pieces) return read_pen_file(whole_pen_file(file.path), name);
  PenFile content = kind->read(file);
  content.kind = kind->name;
  check(file, content);
  check_tools(file, content);
  return content;
}

std::string_view kind_of_pen_file(const PenFileText& file) {
  const std::optional<PenFileKind> kind = kind_of(file.text);
  return kind ? kind->name : std::string_view();
}

}  // namespace burin
