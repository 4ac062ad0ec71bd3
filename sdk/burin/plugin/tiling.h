#pragma once
#include <burin/math/elementary.h>
#include <burin/plugin/cell.h>
#include <burin/plugin/random.h>
#include <burin/plugin/stamps.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace burin::plugin {

/// The arrangement of tiles along and across a stroke. Lengths are multiples of the stroke's greatest radius.
struct TileLayout {
  float length = 2;            ///< length of a tile along the stroke
  float width = 2;             ///< width of a tile across the stroke; row 0 is centred on the stroke
  float gap = 0;               ///< gap between tiles along the stroke; u is outside 0..1 in it
  bool narrow = false;         ///< tiles become narrower together with the stroke
  bool single_row = false;     ///< there is row 0 only; v is outside 0..1 beside it
  float offset_along = 0;      ///< forward shift of the tiles, except start and end tiles, in tiles
  float offset_across = 0;     ///< shift of the rows to the right, in tiles
  bool mirror_along = false;   ///< every other tile along the stroke is mirrored left to right
  bool mirror_across = false;  ///< every other row is mirrored upside down
  bool flip_along = false;     ///< half of the tiles, at random, are mirrored left to right
  bool flip_across = false;    ///< half of the tiles, at random, are mirrored upside down
  bool fit = false;            ///< tiles of an open stroke are stretched to a whole number, as on closed ones
  bool start = false;          ///< an open stroke begins with a tile of its own
  bool end = false;            ///< an open stroke ends with a tile of its own
  std::uint32_t choices = 1;   ///< number of stamps to choose from at random for the other tiles

  /// Sets the width so that this many rows together are as wide as the stroke everywhere.
  void span(int rows) {
    width = 2.0f / static_cast<float>(rows);
    narrow = true;
    offset_across = rows % 2 == 0 ? 0.5f : 0.0f;
  }
};

/// The tile that contains a node, and the position of the node in it.
struct Tile {
  /// Where in the stroke a tile is.
  enum Role { start, middle, end };

  std::int64_t column;  ///< number along the stroke, 0 for the first; on a closed stroke within one turn
  std::int64_t row;     ///< number across the stroke, increasing to the right
  Role role;
  bool on_stroke;        ///< whether the tile's middle is between the ends of the stroke
  std::uint32_t choice;  ///< number of the stamp, below TileLayout::choices
  StampArea area;        ///< the node's cell in the stamp; the tile is (0, 0) .. (1, 1)
  float cosine, sine;    ///< of the angle by which the stamp is turned
  float right, top;      ///< -1 if the stamp is mirrored left to right or upside down; else 1

  /// The components along e1 and e2 of a vector in the stamp's frame (x to the right, y up).
  float along(float x, float y) const { return cosine * right * x - sine * top * y; }
  float across(float x, float y) const { return sine * right * x + cosine * top * y; }
};

/// Maps (t, d) to tiles: u increases along the stroke and v from its left to its right, as on an image that
/// lies on the surface and is read in the direction of travel. Make one per batch.
///
/// Tiles of a periodic image join without a seam, also around a closed stroke. Mirrored tiles join whatever
/// the image is; open it with `options(layout)` so that the filter knows the values outside its borders. A
/// tile depends on its column and row only, also in its random choices, so it does not change while the
/// stroke grows (unless `fit` is set). The position within a tile is exact for the given t. But t is a float
/// with an error of 2^-24 t, which is 1/1700 of a tile 10 000 tiles from the start.
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

  /// How far back from the end of a stroke its tiles depend on the position of the end, object units. Assign
  /// it to StrokeStart::end_influence.
  static double end_influence(const TileLayout& layout, const Stroke& stroke) {
    if (layout.fit || stroke.closed()) return std::numeric_limits<double>::infinity();
    return layout.end ? 2 * stroke.radius_max() * (static_cast<double>(layout.length) + layout.gap) : 0;
  }

  /// The options with which to open a stamp for the tiles between start and end.
  static StampOptions options(const TileLayout& layout) {
    const auto wrap = [](bool alone, bool mirrored) -> burin_stamp_wrap {
      if (alone) return BURIN_WRAP_BLACK;
      return mirrored ? BURIN_WRAP_MIRROR : BURIN_WRAP_UNKNOWN;
    };
    return {wrap(layout.gap > 0, layout.mirror_along), wrap(layout.single_row, layout.mirror_across)};
  }

  /// The tile that contains a cell. Its stamp is turned around its middle by `angle`, radians from e1 towards
  /// e2.
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

  /// Maps vectors from the stroke's (t, d) to the stamp's (right, up), whose unit is the stamp's size.
  struct Frame {
    const Tile& tile;
    const double length, width;

    Vector in_stamp(Vector v) const {
      return {tile.right * (tile.cosine * v.x + tile.sine * v.y) / length,
              tile.top * (tile.cosine * v.y - tile.sine * v.x) / width};
    }
  };

  /// The number of tiles along the stroke if they are stretched to fit; else 0.
  double whole_columns(double pitch) const {
    const bool whole = stroke_.closed() || (layout_.fit && stroke_.has_ends());
    if (!whole || stroke_.length() <= 0) return 0;
    const double pair = layout_.mirror_along && stroke_.closed() ? 2 : 1;
    const double count = pair * std::max(1.0, std::round(stroke_.length() / (pitch * pair)));
    return starts_ && ends_ ? std::max(count, 2.0) : count;
  }

  /// The key of random numbers. Dabs of a stroke have different keys, by their position along the line.
  static std::uint64_t key(const Stroke& stroke) {
    return stroke.dab() ? Random(stroke.seed()).bits(std::bit_cast<std::uint64_t>(stroke.dab_t()))
                        : stroke.seed();
  }

  static StampPoint sides(double u, double v) { return {static_cast<float>(u), static_cast<float>(v)}; }

  /// Sets column, role and on_stroke. Returns the position in the column, 0..1, or outside of it before a
  /// start tile and after an end tile.
  double column_at(float t, Tile& tile) const {
    tile.role = Tile::middle;
    tile.on_stroke = true;
    if (stroke_.dab()) return t / pitch_ + 0.5;
    const double first = t / pitch_, length = stroke_.length() / pitch_;
    // A stroke that is too short for both shows half of each.
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
  const double unit_;  // unit of the layout's lengths, object units
  const Random random_;
  const bool starts_, ends_;
  double columns_;              // number of columns stretched to fit the stroke; 0: not stretched
  double pitch_, tile_length_;  // along the stroke, object units
};

/// Samples a channel of the stamp of each element's tile: tile(i) returns the Tile of element i, stamp(tile)
/// a reference to its Stamp. Writes values 0 .. count - 1. Calls the host once per stamp and block of 256
/// elements. Throws Error if the host cannot sample.
template <class TileOf, class StampOf>
void sample_tiles(std::size_t count, const TileOf& tile, const StampOf& stamp, const FloatsOut& values,
                  std::uint32_t channel = 0) {
  constexpr std::size_t capacity = 256;
  std::array<Tile, capacity> tiles;
  std::array<const Stamp*, capacity> shown;
  std::array<std::size_t, capacity> members;
  std::array<float, capacity> sampled;
  for (std::size_t first = 0; first < count; first += capacity) {
    const std::size_t size = std::min(capacity, count - first);
    for (std::size_t i = 0; i < size; ++i) {
      tiles[i] = tile(first + i);
      shown[i] = &stamp(tiles[i]);
    }
    for (std::size_t i = 0; i < size; ++i) {
      const Stamp* const one = shown[i];
      if (!one) continue;  // sampled together with an earlier element
      std::size_t found = 0;
      for (std::size_t k = i; k < size; ++k) {
        if (shown[k] != one) continue;
        members[found++] = k;
        shown[k] = nullptr;
      }
      one->sample(
          found, [&](std::size_t k) { return tiles[members[k]].area; }, FloatsOut(sampled.data(), 1),
          channel);
      for (std::size_t k = 0; k < found; ++k) values[first + members[k]] = sampled[k];
    }
  }
}

}  // namespace burin::plugin
