#pragma once
#include <burin/math/elementary.h>
#include <burin/plugin/cell.h>
#include <burin/plugin/random.h>
#include <burin/plugin/stamps.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace burin::plugin {

/// How tiles lie along and across a stroke. Lengths are multiples of the stroke's greatest radius.
struct TileLayout {
  float length = 2;            ///< of a tile, along the stroke
  float width = 2;             ///< of a tile, across it; the middle of row 0 runs along the stroke
  float gap = 0;               ///< between tiles along the stroke; there u is beyond 0..1
  bool narrow = false;         ///< tiles are narrower where the stroke is
  bool single_row = false;     ///< row 0 alone; beyond its borders v is beyond 0..1
  float offset_along = 0;      ///< by which the tiles are moved forward, tiles; not those of start and end
  float offset_across = 0;     ///< by which the rows are moved to the right, tiles
  bool mirror_along = false;   ///< every other tile along the stroke is mirrored, left side to the right
  bool mirror_across = false;  ///< every other row is mirrored, upper side to the lower
  bool flip_along = false;     ///< half of the tiles, at random, are mirrored
  bool flip_across = false;    ///< the same upside down
  bool fit = false;            ///< stretched so that an open stroke has whole tiles; a closed one always has
  bool start = false;          ///< an open stroke begins with a tile of its own,
  bool end = false;            ///< and ends with one
  std::uint32_t choices = 1;   ///< stamps to choose from at random for the tiles between

  /// Rows that together are as wide as the stroke, wherever that is.
  void span(int rows) {
    width = 2.0f / static_cast<float>(rows);
    narrow = true;
    offset_across = rows % 2 == 0 ? 0.5f : 0.0f;
  }
};

/// A node's place in its tile.
struct Tile {
  enum Role { start, middle, end };

  std::int64_t column;  ///< along the stroke, 0 the first; on a closed stroke those of one turn
  std::int64_t row;     ///< across it, growing to the right
  Role role;
  bool on_stroke;        ///< its middle is not beyond an end of the stroke
  std::uint32_t choice;  ///< which of TileLayout::choices
  StampArea area;        ///< (0, 0) .. (1, 1) within the tile, what is seen of it through the node's cell
  float cosine, sine;    ///< of the angle by which the stamp is turned
  float right, top;      ///< -1 where the stamp is mirrored left to right, upside down; else 1

  /// Of a vector in the stamp's frame (x to the right, y up): its components along e1 and e2.
  float along(float x, float y) const { return cosine * right * x - sine * top * y; }
  float across(float x, float y) const { return sine * right * x + cosine * top * y; }
};

/// Maps (t, d) to tiles: u grows along the stroke, v from its left to its right, as on an image that lies on
/// the surface and is read in the direction of travel. Made once a batch.
///
/// Where the image is periodic, neighbours join without a seam, round a closed stroke too. Mirrored tiles
/// join whatever the image is; open it with `options(layout)` so that filtering knows what is beyond its
/// borders. Tiles depend on their place alone, so they stay as they are while a stroke grows
/// (unless it is to `fit`): random numbers are keyed by column and row.
/// Place within a tile: exact for the t given, but a t that comes as a float has an error of 2^-24 t, so
/// 10 000 tiles from the start it is 1/1700 of a tile, and a seventh of that at 1400 tiles.
class Tiling {
 public:
  Tiling(const TileLayout& layout, const Stroke& stroke)
      : layout_(layout),
        stroke_(stroke),
        unit_(stroke.radius_max()),
        random_(key(stroke)),
        starts_(layout.start && stroke.has_ends()),
        ends_(layout.end && stroke.has_ends()) {
    const double pitch = unit_ * (static_cast<double>(layout.length) + layout.gap);
    columns_ = whole_columns(pitch);
    pitch_ = columns_ > 0 ? stroke.length() / columns_ : pitch;
    tile_length_ = pitch_ * layout.length / (static_cast<double>(layout.length) + layout.gap);
  }

  /// How far back from the end of a stroke its tiles depend on where that is; for StrokeStart.
  static double end_influence(const TileLayout& layout, const Stroke& stroke) {
    if (layout.fit || stroke.closed()) return std::numeric_limits<double>::infinity();
    return layout.end ? 2 * stroke.radius_max() * (static_cast<double>(layout.length) + layout.gap) : 0;
  }

  /// With which a stamp for the tiles between start and end is to be opened.
  static StampOptions options(const TileLayout& layout) {
    const auto wrap = [](bool alone, bool mirrored) -> burin_stamp_wrap {
      if (alone) return BURIN_WRAP_BLACK;
      return mirrored ? BURIN_WRAP_MIRROR : BURIN_WRAP_UNKNOWN;
    };
    return {wrap(layout.gap > 0, layout.mirror_along), wrap(layout.single_row, layout.mirror_across)};
  }

  /// The tile at a cell; its stamp is turned by `angle` (radians, from e1 towards e2) around its middle.
  Tile at(const Cell& cell, float angle = 0) const {
    Tile tile{};
    const double x = column_at(cell.t, tile);
    const double width =
        unit_ * layout_.width * (layout_.narrow ? static_cast<double>(cell.radius) / unit_ : 1.0);
    const double y = 0.5 - cell.d / width - layout_.offset_across;
    const double row = layout_.single_row ? 0 : std::floor(y);
    tile.row = static_cast<std::int64_t>(row);
    choose(tile);
    tile.cosine = math::cos(angle);
    tile.sine = math::sin(angle);
    const Frame frame{tile, tile_length_, width};
    const Vector middle{(x - 0.5) * pitch_, (0.5 - (y - row)) * width};
    const Vector place = frame.in_stamp(middle);
    const Vector along = frame.in_stamp({cell.footprint_t, 0}),
                 across = frame.in_stamp({0, cell.footprint_d});
    tile.area = {sides(0.5 + place.x, 0.5 - place.y), sides(along.x, -along.y), sides(across.x, -across.y)};
    return tile;
  }

 private:
  struct Vector {
    double x, y;
  };

  /// From the stroke's (t, d) to the stamp's (right, up), whose unit is the stamp's size.
  struct Frame {
    const Tile& tile;
    const double length, width;

    Vector in_stamp(Vector v) const {
      return {tile.right * (tile.cosine * v.x + tile.sine * v.y) / length,
              tile.top * (tile.cosine * v.y - tile.sine * v.x) / width};
    }
  };

  /// How many the stroke has of those that are stretched to fit; 0: no tile is.
  double whole_columns(double pitch) const {
    const bool whole = stroke_.closed() || (layout_.fit && stroke_.has_ends());
    if (!whole || stroke_.length() <= 0) return 0;
    const double pair = layout_.mirror_along && stroke_.closed() ? 2 : 1;
    const double count = pair * std::max(1.0, std::round(stroke_.length() / (pitch * pair)));
    return starts_ && ends_ ? std::max(count, 2.0) : count;
  }

  /// The tiles of a dab are told from those of others by where on its line it lies.
  static std::uint64_t key(const Stroke& stroke) {
    return stroke.dab() ? Random(stroke.seed()).bits(std::bit_cast<std::uint64_t>(stroke.dab_t()))
                        : stroke.seed();
  }

  static StampPlace sides(double u, double v) { return {static_cast<float>(u), static_cast<float>(v)}; }

  /// Sets column and role; the place in the column, 0..1, beyond that before a start and after an end.
  double column_at(float t, Tile& tile) const {
    tile.role = Tile::middle;
    tile.on_stroke = true;
    if (stroke_.dab()) return t / pitch_ + 0.5;
    const double first = t / pitch_, length = stroke_.length() / pitch_;
    // A stroke too short for both shows half of either.
    const double last = std::max(length - 1, starts_ ? std::min(1.0, length / 2) : 0.0);
    if (ends_ && first >= last) {
      tile.role = Tile::end;
      tile.column = static_cast<std::int64_t>(std::ceil(last));
      return first - (length - 1);
    }
    if (starts_ && first < 1) {
      tile.role = Tile::start;
      return first;
    }
    const double x = first - layout_.offset_along, column = std::floor(x);
    tile.column = static_cast<std::int64_t>(column);
    const double middle = column + 0.5 + layout_.offset_along;
    tile.on_stroke = !stroke_.has_ends() || (middle >= 0 && middle <= length);
    if (stroke_.closed() && columns_ > 0)
      tile.column -= static_cast<std::int64_t>(columns_ * std::floor(column / columns_));
    return x - column;
  }

  void choose(Tile& tile) const {
    const auto column = static_cast<std::uint64_t>(tile.column), row = static_cast<std::uint64_t>(tile.row);
    const auto random = [&](std::uint64_t channel) {
      return random_(column << 32 | (row & 0xFFFFFFFF), channel);
    };
    const bool between = tile.role == Tile::middle;
    const bool flip = between && layout_.flip_along && random(0) < 0.5f;
    const bool upside_down = between && layout_.flip_across && random(1) < 0.5f;
    const bool mirror = between && layout_.mirror_along && (tile.column & 1);
    const bool mirror_row = layout_.mirror_across && (tile.row & 1);
    tile.right = flip != mirror ? -1.0f : 1.0f;
    tile.top = upside_down != mirror_row ? -1.0f : 1.0f;
    const float choices = static_cast<float>(layout_.choices);
    tile.choice = between && layout_.choices > 1 ? static_cast<std::uint32_t>(random(2) * choices) : 0;
  }

  const TileLayout layout_;
  const Stroke stroke_;
  const double unit_;  // object units, of the layout's lengths
  const Random random_;
  const bool starts_, ends_;
  double columns_;              // that fit the stroke; 0: they go on however long it gets
  double pitch_, tile_length_;  // along the stroke, object units
};

}  // namespace burin::plugin
