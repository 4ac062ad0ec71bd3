// Reads the Ink Serialized Format of Microsoft: a stream of tags, each with its content. Positions become
// millimetres by the transform that a stroke chooses; pressures become 0..1 by the range of their metric. No
// time of samples is read. Bytes behind the stream are what an older, longer file left.
#include <burin/base/error.h>
#include <burin/ink/decode/isf_stream.h>
#include <burin/ink/decode/isf_tables.h>
#include <burin/ink/decode/tilt_angles.h>
#include <burin/ink/kinds/kinds.h>
#include <burin/ink/parse/isf_array.h>
#include <burin/ink/pen_file.h>
#include <burin/math/degree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace burin {
namespace {

enum Tag : std::uint64_t {
  rectangle = 0,
  attributes_index = 9,
  stroke = 10,
  descriptor_index = 13,
  transform_index = 23,
  metric_index = 26
};

constexpr double hundredth_of_millimetre = 0.01;

/// Most points of a file: packed ones take a bit each, so that a small file could fill the memory.
constexpr std::size_t most_points = std::size_t{1} << 20;

/// What strokes have in common until a tag changes it, and how many points there were.
struct Chosen {
  std::size_t descriptor = 0, transform = 0, metrics = 0, points = 0;
};

template <class Item>
Item item_or_default(const std::vector<Item>& items, std::size_t index, Item otherwise) {
  return index < items.size() ? items[index] : otherwise;
}

using Columns = std::map<std::uint64_t, std::vector<std::int64_t>>;

void set_pressures(const Columns& columns, const IsfMetrics& metrics, PenStroke& stroke) {
  const auto found = columns.find(isf_pressure);
  if (found == columns.end()) return;
  const IsfMetric metric = isf_metric_of(metrics, isf_pressure);
  const std::int64_t most = metric.most, least = metric.least;
  if (most <= least) return;
  stroke.fields.pressure = true;
  for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
    const double share = (static_cast<double>(found->second[i]) - static_cast<double>(least)) /
                         (static_cast<double>(most) - static_cast<double>(least));
    stroke.samples[i].pen.pressure = static_cast<float>(share);
  }
}

/// Radians of a number of this property; 0 if its metric does not tell.
double radians_of_one(const IsfMetrics& metrics, std::uint64_t property) {
  const IsfMetric metric = isf_metric_of(metrics, property);
  if (!(metric.precision > 0)) return 0;
  if (metric.unit == isf_radians) return 1 / double{metric.precision};
  return metric.unit == isf_degrees ? math::degree / metric.precision : 0;
}

void set_tilts(const Columns& columns, const IsfMetrics& metrics, PenStroke& stroke) {
  const auto angles = [&](std::uint64_t x, std::uint64_t y, const auto& set) {
    const auto first = columns.find(x), second = columns.find(y);
    const double by_first = radians_of_one(metrics, x), by_second = radians_of_one(metrics, y);
    if (first == columns.end() || second == columns.end() || by_first == 0 || by_second == 0) return;
    stroke.fields.tilt = true;
    for (std::size_t i = 0; i < stroke.samples.size(); ++i)
      set(stroke.samples[i].pen, static_cast<double>(first->second[i]) * by_first,
          static_cast<double>(second->second[i]) * by_second);
  };
  angles(isf_tilt_x, isf_tilt_y, [](Pen& pen, double x, double y) {
    // Ranges of a whole turn have tilts to the other side above a half.
    pen.tilt_x = static_cast<float>(std::remainder(x, 2 * std::numbers::pi));
    pen.tilt_y = static_cast<float>(std::remainder(y, 2 * std::numbers::pi));
  });
  angles(isf_azimuth, isf_altitude,
         [](Pen& pen, double azimuth, double altitude) { set_tilt(pen, azimuth, altitude); });
}

void set_twists(const Columns& columns, const IsfMetrics& metrics, PenStroke& stroke) {
  const auto found = columns.find(isf_twist);
  const double by_one = radians_of_one(metrics, isf_twist);
  if (found == columns.end() || by_one == 0) return;
  stroke.fields.twist = true;
  for (std::size_t i = 0; i < stroke.samples.size(); ++i)
    stroke.samples[i].pen.twist = static_cast<float>(static_cast<double>(found->second[i]) * by_one);
}

/// A status tells whether the pen is inverted, so that its eraser touches.
void set_eraser(const Columns& columns, PenStroke& stroke) {
  constexpr std::int64_t inverted = 2;
  const auto found = columns.find(isf_packet_status);
  stroke.drawn_by.eraser =
      found != columns.end() &&
      std::ranges::any_of(found->second, [](std::int64_t status) { return (status & inverted) != 0; });
}

/// Buttons lie behind all arrays, as many bits for each packet: from the most significant bit of each byte
/// on, the last button first. How more than eight are packed is not known.
void set_barrels(const IsfDescriptor& descriptor, ByteReader& content, PenStroke& stroke) {
  constexpr std::size_t byte = 8;
  if (!descriptor.barrel || descriptor.buttons > byte || content.empty()) return;
  const std::size_t count = descriptor.buttons * stroke.samples.size();
  const std::string_view bits = content.take_bytes((count + byte - 1) / byte);
  stroke.fields.barrel = true;
  for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
    const std::size_t at = (i + 1) * descriptor.buttons - 1 - *descriptor.barrel;
    stroke.samples[i].barrel =
        (static_cast<unsigned char>(bits[at / byte]) >> (byte - 1 - at % byte) & 1) != 0;
  }
}

PenStroke read_stroke(ByteReader content, const IsfTables& tables, Chosen& chosen) {
  constexpr std::uint64_t x_property = 50, y_property = 51;
  const IsfDescriptor descriptor = item_or_default(tables.descriptors, chosen.descriptor, IsfDescriptor{});
  const IsfMetrics metrics = item_or_default(tables.metrics, chosen.metrics, IsfMetrics{});
  const Eigen::Affine2d place =
      item_or_default(tables.transforms, chosen.transform, Eigen::Affine2d(Eigen::Affine2d::Identity()));
  constexpr std::size_t most_points_a_byte = 8;
  const std::uint64_t told = content.varint();
  if (told > content.left() * most_points_a_byte) content.reject("more points are told than bytes can hold");
  if (told > most_points - chosen.points) content.reject("a file of more than 1048576 points");
  chosen.points += told;
  const auto points = static_cast<std::size_t>(told);
  Columns columns;
  if (descriptor.x) columns[x_property] = take_isf_array(content, points);
  if (descriptor.y) columns[y_property] = take_isf_array(content, points);
  for (const std::uint64_t property : descriptor.properties)
    columns[property] = take_isf_array(content, points);
  PenStroke made;
  made.samples.resize(points);
  for (std::size_t i = 0; i < points; ++i) {
    const Eigen::Vector2d raw(descriptor.x ? static_cast<double>(columns[x_property][i]) : 0,
                              descriptor.y ? static_cast<double>(columns[y_property][i]) : 0);
    made.samples[i].position.head<2>() = hundredth_of_millimetre * (place * raw);
  }
  set_pressures(columns, metrics, made);
  set_tilts(columns, metrics, made);
  set_twists(columns, metrics, made);
  set_eraser(columns, made);
  set_barrels(descriptor, content, made);
  return made;
}

/// Removes the content of a tag that is not used. Properties that WPF knows have as many bytes as these; the
/// length of others does not count the byte that tells how they are packed.
void skip_other(std::uint64_t tag, ByteReader& stream) {
  constexpr std::uint64_t first_property = 50;
  constexpr std::array<std::uint8_t, 38> bytes_of_known = {4,  4,  4,  4, 8, 4, 2, 2, 2, 4, 4, 4, 4,
                                                           4,  2,  2,  2, 2, 4, 4, 4, 1, 4, 4, 0, 0,
                                                           20, 12, 16, 2, 1, 4, 0, 4, 4, 4, 4, 4};
  const bool property = tag >= first_property;
  if (property && tag - first_property < bytes_of_known.size())
    if (const std::uint8_t bytes = bytes_of_known[tag - first_property]; bytes > 0) {
      stream.take_bytes(bytes);
      return;
    }
  stream.part(stream.varint());
  if (property) stream.take_bytes(1);
}

void read_tag(std::uint64_t tag, ByteReader& stream, IsfTables& tables, Chosen& chosen, PenFile& content) {
  if (read_isf_table(tag, stream, tables)) return;
  switch (tag) {
    case Tag::rectangle:
      for (int i = 0; i < 4; ++i) stream.varint();
      break;
    case Tag::attributes_index:
      stream.varint();
      break;
    case Tag::descriptor_index:
      chosen.descriptor = stream.varint();
      break;
    case Tag::transform_index:
      chosen.transform = stream.varint();
      break;
    case Tag::metric_index:
      chosen.metrics = stream.varint();
      break;
    case Tag::stroke: {
      PenStroke made = read_stroke(stream.part(stream.varint()), tables, chosen);
      if (!made.samples.empty()) content.strokes.push_back(std::move(made));
      break;
    }
    default:
      skip_other(tag, stream);
  }
}

}  // namespace

bool is_isf(std::string_view text) {
  if (text.starts_with("GIF8") || text.starts_with("base64:")) return true;
  if (!text.starts_with('\0')) return false;
  const std::filesystem::path none;
  try {
    ByteReader stream(text.substr(1), none);
    const std::uint64_t size = stream.varint();
    return size > 0 && size <= stream.left();
  } catch (const FileError&) {
    return false;
  }
}

PenFile read_isf(const PenFileText& file) {
  const std::string bytes = isf_stream(file);
  ByteReader whole(bytes, file.path);
  if (whole.varint() != 0) whole.reject("no stream of the Ink Serialized Format");
  ByteReader stream = whole.part(whole.varint());
  PenFile content;
  content.unit = "mm";
  content.millimetres = 1;
  IsfTables tables;
  Chosen chosen;
  while (!stream.empty()) {
    const std::uint64_t tag = stream.varint();
    read_tag(tag, stream, tables, chosen, content);
  }
  return content;
}

}  // namespace burin
