// Reads lines from the blocks of reMarkable's version 6. Values have a tag: their index, and how they are
// written. A line tells its neighbours by ids, which order the lines; deleted ones stay as neighbours only.
#include <burin/ink/decode/remarkable_blocks.h>
#include <burin/ink/decode/remarkable_order.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace burin {
namespace {

enum Written : std::uint8_t { one_byte = 1, four_bytes = 4, eight_bytes = 8, part = 12, id = 15 };

/// A tagged value, of which only what its kind has is set.
struct Tagged {
  std::uint64_t index = 0;
  RemarkableId id;
  std::uint64_t number = 0;
  ByteReader content;
};

RemarkableId take_id(ByteReader& bytes) {
  const auto author = bytes.take<std::uint8_t>();
  return {author, bytes.varint()};
}

Tagged take_tagged(ByteReader& bytes) {
  const std::uint64_t tag = bytes.varint();
  Tagged value{.index = tag >> 4, .id = {}, .content = {{}, bytes.path(), bytes.place()}};
  switch (tag & 0xF) {
    case Written::one_byte:
      value.number = bytes.take<std::uint8_t>();
      break;
    case Written::four_bytes:
      value.number = bytes.take<std::uint32_t>();
      break;
    case Written::eight_bytes:
      value.number = bytes.take<std::uint64_t>();
      break;
    case Written::part:
      value.content = bytes.part(bytes.take<std::uint32_t>());
      break;
    case Written::id:
      value.id = take_id(bytes);
      break;
    default:
      bytes.reject("no tagged value");
  }
  return value;
}

/// Reads the value of a line item behind its heads.
PenStroke read_line(ByteReader bytes, RemarkablePoints points) {
  constexpr std::uint64_t pen_index = 1, points_index = 5;
  constexpr std::uint8_t item_of_line = 3;
  PenStroke stroke;
  if (bytes.take<std::uint8_t>() != item_of_line) bytes.reject("no line in a line item");
  while (!bytes.empty()) {
    const Tagged value = take_tagged(bytes);
    if (value.index == pen_index) set_remarkable_pen(static_cast<std::uint32_t>(value.number), stroke);
    if (value.index == points_index) add_remarkable_points(value.content, points, stroke);
  }
  return stroke;
}

/// An item of a layer: a line, or what a deleted one left.
struct LineItem {
  RemarkableId layer;
  RemarkableNeighbours neighbours;
  PenStroke stroke;
};

LineItem read_item(ByteReader bytes, RemarkablePoints points) {
  enum Index : std::uint8_t { layer = 1, own, left, right, deleted, line };
  LineItem item;
  while (!bytes.empty()) {
    const Tagged value = take_tagged(bytes);
    switch (value.index) {
      case Index::layer:
        item.layer = value.id;
        break;
      case Index::own:
        item.neighbours.own = value.id;
        break;
      case Index::left:
        item.neighbours.left = value.id;
        break;
      case Index::right:
        item.neighbours.right = value.id;
        break;
      case Index::line:
        item.stroke = read_line(value.content, points);
        break;
      default:
        break;
    }
  }
  return item;
}

std::vector<LineItem> read_items(ByteReader bytes) {
  constexpr std::uint8_t type_of_line_item = 5;
  std::vector<LineItem> items;
  while (!bytes.empty()) {
    const auto length = bytes.take<std::uint32_t>();
    bytes.take_bytes(2);  // nothing, and the least version that reads the block
    const auto version = bytes.take<std::uint8_t>(), type = bytes.take<std::uint8_t>();
    const ByteReader block = bytes.part(length);
    if (type == type_of_line_item)
      items.push_back(read_item(block, version < 2 ? RemarkablePoints::floats : RemarkablePoints::small));
  }
  return items;
}

}  // namespace

void add_remarkable_points(ByteReader bytes, RemarkablePoints points, PenStroke& stroke) {
  const bool small = points == RemarkablePoints::small;
  if (bytes.left() % (small ? remarkable_small_point : remarkable_float_point) != 0)
    bytes.reject("a part of a point");
  stroke.fields.pressure = true;
  while (!bytes.empty()) {
    Sample& sample = stroke.samples.emplace_back();
    sample.position.x() = bytes.take<float>();
    sample.position.y() = bytes.take<float>();
    constexpr float quarter = 0.25F, most_byte = 255;
    if (small) {
      bytes.take_bytes(2);  // the speed
      stroke.widths.push_back(quarter * bytes.take<std::uint16_t>());
      bytes.take_bytes(1);  // the direction
      sample.pen.pressure = bytes.take<std::uint8_t>() / most_byte;
    } else {
      bytes.take_bytes(8);  // speed and direction
      stroke.widths.push_back(bytes.take<float>());
      sample.pen.pressure = bytes.take<float>();
    }
  }
}

void set_remarkable_pen(std::uint32_t pen, PenStroke& stroke) {
  constexpr std::uint32_t eraser = 6, eraser_of_areas = 8;
  stroke.tool = "pen";
  stroke.eraser = pen == eraser || pen == eraser_of_areas;
}

void read_remarkable_blocks(ByteReader bytes, PenFile& content) {
  std::vector<LineItem> items = read_items(bytes);
  std::vector<RemarkableId> layers;
  for (const LineItem& item : items)
    if (std::ranges::find(layers, item.layer) == layers.end()) layers.push_back(item.layer);
  for (std::size_t layer = 0; layer < layers.size(); ++layer) {
    std::vector<LineItem*> of_layer;
    std::vector<RemarkableNeighbours> neighbours;
    for (LineItem& item : items) {
      if (item.layer != layers[layer]) continue;
      of_layer.push_back(&item);
      neighbours.push_back(item.neighbours);
    }
    for (const std::size_t i : order_of(neighbours)) {
      if (of_layer[i]->stroke.samples.empty()) continue;
      of_layer[i]->stroke.layer = layer + 1;
      content.strokes.push_back(std::move(of_layer[i]->stroke));
    }
  }
}

}  // namespace burin
