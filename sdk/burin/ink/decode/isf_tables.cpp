// Reads the tables of the Ink Serialized Format: what packets have, how they are placed, and what their
// numbers mean.
#include <burin/ink/decode/isf_tables.h>
#include <burin/ink/parse/isf_array.h>
#include <burin/math/elementary.h>

#include <numbers>
#include <string_view>

namespace burin {
namespace {

enum Tag : std::uint64_t {
  guid_table = 1,
  descriptor_table = 4,
  descriptor_block = 5,
  transform_table = 15,
  transform = 16,
  same_scale = 17,
  two_scales = 18,
  turned = 19,
  moved = 20,
  scaled_and_moved = 21,
  metric_table = 24,
  metric_block = 25
};

/// Of the button at the pen's side, f0720328-663b-418f-85a6-9531ae3ecdfa, as the file has it.
constexpr std::string_view barrel_guid = "\x28\x03\x72\xf0\x3b\x66\x8f\x41\x85\xa6\x95\x31\xae\x3e\xcd\xfa";

/// The tag that a table of GUIDs gives to the button at the pen's side.
std::optional<std::uint64_t> barrel_in(ByteReader guids) {
  constexpr std::uint64_t first_tag = 100;
  for (std::uint64_t tag = first_tag; guids.left() >= barrel_guid.size(); ++tag)
    if (guids.take_bytes(barrel_guid.size()) == barrel_guid) return tag;
  return std::nullopt;
}

/// Reads how many buttons there are, and the tag of each.
void read_buttons(ByteReader& content, const IsfTables& tables, IsfDescriptor& descriptor) {
  constexpr std::uint64_t usual_barrel_tag = 85;
  descriptor.buttons = content.count(content.varint(), 1);
  for (std::size_t i = 0; i < descriptor.buttons; ++i)
    if (const std::uint64_t tag = content.varint(); tag == usual_barrel_tag || tag == tables.barrel_tag)
      descriptor.barrel = i;
}

IsfDescriptor read_descriptor(ByteReader content, const IsfTables& tables) {
  constexpr std::uint64_t buttons = 6, no_x = 7, no_y = 8, stroke_properties = 11;
  IsfDescriptor descriptor;
  while (!content.empty()) {
    const std::uint64_t tag = content.varint();
    if (tag == buttons) read_buttons(content, tables, descriptor);
    if (tag == buttons || tag == stroke_properties) break;
    if (tag == no_x)
      descriptor.x = false;
    else if (tag == no_y)
      descriptor.y = false;
    else
      descriptor.properties.push_back(tag);
  }
  return descriptor;
}

IsfMetrics read_metrics(ByteReader content) {
  IsfMetrics metrics;
  while (!content.empty()) {
    const std::uint64_t property = content.varint();
    ByteReader of_property = content.part(content.varint());
    IsfMetric& metric = metrics.try_emplace(property, isf_usual_metric(property)).first->second;
    if (!of_property.empty()) metric.least = take_isf_signed(of_property);
    if (!of_property.empty()) metric.most = take_isf_signed(of_property);
    if (!of_property.empty()) metric.unit = of_property.varint();
    if (of_property.left() >= sizeof(float)) metric.precision = of_property.take<float>();
  }
  return metrics;
}

/// A matrix of what x gives x, what y gives x, what x gives y, what y gives y, and what is added.
Eigen::Affine2d affine(double xx, double xy, double yx, double yy, double dx, double dy) {
  Eigen::Affine2d made = Eigen::Affine2d::Identity();
  made.linear() << xx, xy, yx, yy;
  made.translation() << dx, dy;
  return made;
}

Eigen::Affine2d read_transform(std::uint64_t tag, ByteReader& stream) {
  const auto next = [&stream] { return double{stream.take<float>()}; };
  if (tag == Tag::turned) {
    constexpr double hundredth_of_degree = std::numbers::pi / 18000;
    const double angle = static_cast<double>(stream.varint()) * hundredth_of_degree;
    return affine(math::cos(angle), -math::sin(angle), math::sin(angle), math::cos(angle), 0, 0);
  }
  const double a = next(), b = tag == Tag::same_scale ? a : next();
  if (tag == Tag::moved) return affine(1, 0, 0, 1, a, b);
  if (tag == Tag::same_scale || tag == Tag::two_scales) return affine(a, 0, 0, b, 0, 0);
  const double c = next(), d = next();
  if (tag == Tag::scaled_and_moved) return affine(a, 0, 0, b, c, d);
  // The file has what x gives to both first, as WPF reads it.
  const double e = next(), f = next();
  return affine(a, c, b, d, e, f);
}

bool is_transform(std::uint64_t tag) { return tag >= Tag::transform && tag <= Tag::scaled_and_moved; }

Eigen::Affine2d read_transform_of_table(ByteReader& table) {
  const std::uint64_t tag = table.varint();
  if (!is_transform(tag)) table.reject("no transform in the table of transforms");
  return read_transform(tag, table);
}

/// The items that `read` takes from a table to its end.
template <class Read>
auto list_in(ByteReader table, const Read& read) {
  std::vector<decltype(read(table))> items;
  while (!table.empty()) items.push_back(read(table));
  return items;
}

}  // namespace

IsfMetric isf_usual_metric(std::uint64_t property) {
  constexpr std::int64_t usual_pressure = 1023;
  if (property == isf_pressure) return {.most = usual_pressure};
  if (property >= isf_tilt_x && property <= isf_twist) return {.unit = isf_degrees, .precision = 10};
  return {};
}

IsfMetric isf_metric_of(const IsfMetrics& metrics, std::uint64_t property) {
  const auto told = metrics.find(property);
  return told == metrics.end() ? isf_usual_metric(property) : told->second;
}

bool read_isf_table(std::uint64_t tag, ByteReader& stream, IsfTables& tables) {
  if (is_transform(tag)) {
    tables.transforms = {read_transform(tag, stream)};
    return true;
  }
  if (tag != Tag::guid_table && tag != Tag::descriptor_table && tag != Tag::descriptor_block &&
      tag != Tag::transform_table && tag != Tag::metric_table && tag != Tag::metric_block)
    return false;
  ByteReader content = stream.part(stream.varint());
  if (tag == Tag::guid_table) tables.barrel_tag = barrel_in(content);
  if (tag == Tag::descriptor_block) tables.descriptors = {read_descriptor(content, tables)};
  if (tag == Tag::metric_block) tables.metrics = {read_metrics(content)};
  if (tag == Tag::descriptor_table)
    tables.descriptors =
        list_in(content, [&](ByteReader& list) { return read_descriptor(list.part(list.varint()), tables); });
  if (tag == Tag::metric_table)
    tables.metrics =
        list_in(content, [](ByteReader& list) { return read_metrics(list.part(list.varint())); });
  if (tag == Tag::transform_table) tables.transforms = list_in(content, read_transform_of_table);
  return true;
}

}  // namespace burin
