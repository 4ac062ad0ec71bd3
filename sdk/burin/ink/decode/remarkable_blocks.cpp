// Reads lines from the blocks of reMarkable's version 6. A line tells its neighbours by ids, which order the
// lines; deleted ones stay as neighbours only.
#include <burin/ink/decode/remarkable_blocks.h>
#include <burin/ink/decode/remarkable_scene.h>
#include <burin/ink/decode/remarkable_text.h>
#include <burin/ink/parse/remarkable_tagged.h>

#include <cstdint>

namespace burin {
namespace {

/// Reads the value of a line item behind its heads.
PenStroke read_line(ByteReader bytes, RemarkablePoints points) {
  constexpr std::uint64_t pen_index = 1, points_index = 5;
  constexpr std::uint8_t item_of_line = 3;
  PenStroke stroke;
  if (bytes.take<std::uint8_t>() != item_of_line) bytes.reject("no line in a line item");
  while (!bytes.empty()) {
    const RemarkableValue value = take_remarkable_value(bytes);
    if (value.index == pen_index) set_remarkable_pen(static_cast<std::uint32_t>(value.number), stroke);
    if (value.index == points_index) add_remarkable_points(value.content, points, stroke);
  }
  return stroke;
}

/// Reads the value of a group item behind its heads.
RemarkableId read_group(ByteReader bytes) {
  constexpr std::uint8_t item_of_group = 2;
  if (bytes.take<std::uint8_t>() != item_of_group) bytes.reject("no group in a group item");
  return take_remarkable_value(bytes).id;
}

/// Reads the heads of an item, and its value by `read`.
template <class Read>
RemarkableItem read_item(ByteReader bytes, const Read& read) {
  enum Index : std::uint8_t { parent = 1, own, left, right, deleted, content };
  RemarkableItem item;
  while (!bytes.empty()) {
    const RemarkableValue value = take_remarkable_value(bytes);
    switch (value.index) {
      case Index::parent:
        item.parent = value.id;
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
      case Index::content:
        read(value.content, item);
        break;
      default:
        break;
    }
  }
  return item;
}

/// Reads what a block tells of a layer or group, which may be tied to text.
void read_node(ByteReader bytes, RemarkableScene& scene) {
  enum Index : std::uint8_t { node = 1, anchor = 7, anchor_x = 10 };
  RemarkableId id;
  while (!bytes.empty()) {
    const RemarkableValue value = take_remarkable_value(bytes);
    if (value.index == Index::node) id = value.id;
    if (value.index == Index::anchor) scene.anchors[id].character = last_set_value(value.content).id;
    if (value.index == Index::anchor_x) scene.anchors[id].x = real_of(last_set_value(value.content));
  }
}

void read_block(std::uint8_t type, std::uint8_t version, const ByteReader& block, RemarkableScene& scene) {
  enum Type : std::uint8_t { node = 2, group = 4, line = 5, text = 7 };
  const auto points = version < 2 ? RemarkablePoints::floats : RemarkablePoints::small;
  if (type == Type::node) read_node(block, scene);
  // A page has one text, whose lines are never none.
  if (type == Type::text && scene.text_lines.empty()) scene.text_lines = remarkable_text_lines(block);
  if (type == Type::group)
    scene.items.push_back(read_item(
        block, [](const ByteReader& value, RemarkableItem& item) { item.group = read_group(value); }));
  if (type == Type::line)
    scene.items.push_back(read_item(block, [points](const ByteReader& value, RemarkableItem& item) {
      item.stroke = read_line(value, points);
    }));
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
  stroke.drawn_by = {"pen", pen == eraser || pen == eraser_of_areas};
}

void read_remarkable_blocks(ByteReader bytes, PenFile& content) {
  RemarkableScene scene;
  while (!bytes.empty()) {
    const auto length = bytes.take<std::uint32_t>();
    bytes.take_bytes(2);  // nothing, and the least version that reads the block
    const auto version = bytes.take<std::uint8_t>(), type = bytes.take<std::uint8_t>();
    read_block(type, version, bytes.part(length), scene);
  }
  scene.add_lines_to(content, bytes);
}

}  // namespace burin
