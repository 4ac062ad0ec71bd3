// Reads sketches of Tilt Brush and Open Brush: a head that tells its size, 16 bytes, and a zip whose member
// data.sketch has the strokes, or that member by itself. Points lie in space, x to the right, y up and z
// forward, in units of 0.1 m; z is turned towards the viewer here. The brush is held in the air: it has an
// orientation, and no tilt against a plane.
#include <burin/ink/kinds/kinds.h>
#include <burin/ink/parse/byte_reader.h>
#include <burin/ink/parse/unpack.h>
#include <burin/ink/pen_file.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace burin {
namespace {

constexpr std::string_view tilt_magic = "tilT";
constexpr std::string_view sketch_magic = "\xcd\xa5\x76\xc5";
constexpr unsigned mask_bits = 32, short_bits = 16;

/// What the words that a mask tells of a stroke say.
struct Extension {
  float scale = 1;
  std::uint32_t layer = 0;  ///< in sketches of Open Brush, from 0
};

Extension read_extension(ByteReader& bytes, std::uint32_t mask) {
  constexpr unsigned scale_bit = 1, layer_bit = 4;
  Extension read;
  for (unsigned bit = 0; bit < mask_bits; ++bit) {
    if (!(mask >> bit & 1)) continue;
    if (bit >= short_bits)
      bytes.take_bytes(bytes.take<std::uint32_t>());
    else if (bit == scale_bit)
      read.scale = bytes.take<float>();
    else if (bit == layer_bit)
      read.layer = bytes.take<std::uint32_t>();
    else
      bytes.take_bytes(4);
  }
  return read;
}

Sample read_point(ByteReader& bytes, std::uint32_t mask) {
  constexpr std::size_t quaternion_bytes = 16;
  Sample sample;
  for (int axis = 0; axis < 3; ++axis) sample.position[axis] = bytes.take<float>();
  sample.position.z() = -sample.position.z();
  bytes.take_bytes(quaternion_bytes);
  for (unsigned bit = 0; bit < mask_bits; ++bit) {
    if (!(mask >> bit & 1)) continue;
    if (bit == 0)
      sample.pen.pressure = bytes.take<float>();
    else if (bit == 1)
      sample.time = bytes.take<std::uint32_t>() / 1000.;
    else
      bytes.take_bytes(4);
  }
  return sample;
}

PenStroke read_stroke(ByteReader& bytes) {
  constexpr std::size_t brush_and_colour = 20, least_point = 28;
  bytes.take_bytes(brush_and_colour);
  const auto size = bytes.take<float>();
  const auto stroke_mask = bytes.take<std::uint32_t>(), point_mask = bytes.take<std::uint32_t>();
  const Extension extension = read_extension(bytes, stroke_mask);
  PenStroke stroke;
  stroke.layer = 1 + std::size_t{extension.layer};
  stroke.has_z = true;
  stroke.fields.pressure = point_mask & 1;
  stroke.fields.time = point_mask & 2;
  const std::size_t points = bytes.count(bytes.take<std::uint32_t>(), least_point);
  for (std::size_t i = 0; i < points; ++i) stroke.samples.push_back(read_point(bytes, point_mask));
  stroke.widths.assign(points, size * extension.scale);
  return stroke;
}

void read_sketch(ByteReader bytes, PenFile& content) {
  constexpr std::size_t version_and_reserved = 8, least_stroke = 40;
  if (bytes.take_bytes(sketch_magic.size()) != sketch_magic) bytes.reject("no sketch");
  bytes.take_bytes(version_and_reserved);
  bytes.take_bytes(bytes.take<std::uint32_t>());
  const std::size_t strokes = bytes.count(bytes.take<std::uint32_t>(), least_stroke);
  for (std::size_t i = 0; i < strokes; ++i) {
    PenStroke stroke = read_stroke(bytes);
    if (!stroke.samples.empty()) content.strokes.push_back(std::move(stroke));
  }
  if (!bytes.empty()) bytes.reject("bytes follow the last stroke");
}

}  // namespace

bool is_tilt(std::string_view text) { return text.starts_with(tilt_magic) || text.starts_with(sketch_magic); }

PenFile read_tilt(const PenFileText& file) {
  PenFile content;
  content.unit = "dm";
  content.millimetres = 100;
  const std::string_view text = file.text;
  if (text.starts_with(sketch_magic)) {
    read_sketch({text, file.path}, content);
  } else {
    ByteReader head(text, file.path);
    head.take_bytes(tilt_magic.size());
    const auto head_size = head.take<std::uint16_t>();
    head.take_bytes(std::max<std::size_t>(head_size, head.place()) - head.place());
    const std::string sketch = zip_member(file.path, head.bytes(), sketch_member);
    read_sketch({sketch, file.path}, content);
  }
  return content;
}

}  // namespace burin
