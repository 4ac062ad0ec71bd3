// Reads WILL 2 of Wacom: RIFF with a chunk of paths, or these by themselves as members of a zip have them,
// each with its length, as messages of Protocol Buffers. The numbers of a path are differences in steps of
// 10^-precision. Its points are control points of a Catmull-Rom spline and the only ones that the file has;
// nothing tells time or pressure.
#include <burin/base/error.h>
#include <burin/ink/kinds/kinds.h>
#include <burin/ink/parse/protobuf.h>
#include <burin/ink/parse/riff.h>
#include <burin/ink/pen_file.h>

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

namespace burin {
namespace {

/// The fields of a path's message.
struct Path {
  std::uint64_t precision = 2;
  std::vector<std::int64_t> points, widths;
};

Path path_of(ByteReader message) {
  Path path;
  while (!message.empty()) {
    const ProtobufField field = next_field(message);
    if (field.number == 3) path.precision = field.value;
    if (field.number == 4) field.append_signed(path.points);
    if (field.number == 5) field.append_signed(path.widths);
  }
  return path;
}

/// Sums of every n-th number, in steps of 10^-precision.
std::vector<double> summed(const std::vector<std::int64_t>& numbers, std::size_t n, double steps) {
  std::vector<std::uint64_t> sums(n);  // unsigned, since damaged files overflow
  std::vector<double> values;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    values.push_back(static_cast<double>(
                         static_cast<std::int64_t>(sums[i % n] += static_cast<std::uint64_t>(numbers[i]))) /
                     steps);
  return values;
}

PenStroke stroke_of(const ByteReader& message) {
  constexpr std::uint64_t most_precision = 15;
  const Path path = path_of(message);
  if (path.precision > most_precision) message.reject("the precision of a path must lie in 0..15");
  if (path.points.size() % 2 != 0) message.reject("a path with an x without y");
  double steps = 1;
  for (std::uint64_t i = 0; i < path.precision; ++i) steps *= 10;
  const std::vector<double> points = summed(path.points, 2, steps);
  PenStroke stroke;
  for (std::size_t i = 0; i < points.size(); i += 2)
    stroke.samples.push_back({.time = 0, .position = {points[i], points[i + 1], 0}, .pen = {}});
  for (const double width : summed(path.widths, 1, steps)) stroke.widths.push_back(static_cast<float>(width));
  if (!stroke.widths.empty()) stroke.widths.resize(stroke.samples.size(), stroke.widths.back());
  return stroke;
}

void read_paths(ByteReader paths, PenFile& content) {
  while (!paths.empty()) {
    PenStroke stroke = stroke_of(paths.part(paths.varint()));
    if (!stroke.samples.empty()) content.strokes.push_back(std::move(stroke));
  }
}

/// Whether the bytes are paths by themselves: lengths that end where the bytes do, and first a field of a
/// path.
bool are_paths(std::string_view text) {
  constexpr std::string_view first_fields = "\x0d\x15\x18\x22";
  if (text.starts_with('{')) return false;  // of JSON, whose {" reads as a length and a field
  const std::filesystem::path none;
  ByteReader paths(text, none);
  try {
    while (!paths.empty()) {
      const ByteReader path = paths.part(paths.varint());
      if (path.empty() || first_fields.find(path.bytes().front()) == first_fields.npos) return false;
    }
  } catch (const FileError&) {
    return false;
  }
  return !text.empty();
}

}  // namespace

bool is_will(std::string_view text) { return is_riff(text, "WILL") || are_paths(text); }

PenFile read_will(const PenFileText& file) {
  PenFile content;
  content.unit = "px";
  if (!is_riff(file.text, "WILL"))
    read_paths({file.text, file.path}, content);
  else
    for (RiffChunks chunks(file.text, file.path); !chunks.empty();) {
      const RiffChunk chunk = chunks.next();
      if (chunk.name == "INK ") read_paths(chunk.content, content);
    }
  return content;
}

}  // namespace burin
