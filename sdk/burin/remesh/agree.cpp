// Two meshes of one surface that are cut by the same field differ where the field has an extremum or a saddle
// near 0: one of them has a small island or hole there which the other one misses. Both meshes describe the
// surface equally well there, so such a disc is given to the side that surrounds it.
#include <burin/remesh/agree.h>
#include <burin/remesh/common_line.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace burin {
namespace {

std::vector<Loop> lines_of(const DividedPatch& divided) {
  return border_loops({divided.patch.positions, kept_triangles(divided), divided.patch.kept});
}

/// Triangles that hang together on one side of the lines.
struct Region {
  std::vector<std::size_t> triangles;
  std::size_t border = 0;  ///< number of its sides beyond which another region lies or nothing
  double depth = 0;        ///< greatest distance of the field from 0
};

/// Moves discs of a divided patch to the other side.
class Discs {
 public:
  explicit Discs(DividedPatch& divided) : divided_(&divided) {
    for (std::size_t t = 0; t < divided.patch.triangles.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i) triangle_at_[side(t, i)] = t;
  }

  /// The disc that a line surrounds moves to the other side; false where neither side of it is one.
  bool move(const Loop& line, double shallow) {
    if (line.size() < 3) return false;  // a part of a line that ends at fixed vertices
    const Side along{line[0], line[1]};
    for (const Side& start : {along, Side{along.second, along.first}}) {
      const auto triangle = triangle_at_.find(start);
      if (triangle == triangle_at_.end()) continue;
      const Region region = region_at(triangle->second);
      if (region.border != line.size() || region.depth > shallow) continue;
      for (const std::size_t t : region.triangles) divided_->kept[t] = divided_->kept[t] ? 0 : 1;
      return true;
    }
    return false;
  }

 private:
  Side side(std::size_t triangle, std::size_t i) const {
    const Triangle& t = divided_->patch.triangles[triangle];
    return {t[i], t[(i + 1) % 3]};
  }

  Region region_at(std::size_t start) const {
    Region region{{start}};
    std::vector<bool> seen(divided_->kept.size(), false);
    seen[start] = true;
    for (std::size_t next = 0; next < region.triangles.size(); ++next) {
      const std::size_t t = region.triangles[next];
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [from, to] = side(t, i);
        region.depth = std::max(region.depth, std::abs(divided_->field[from]));
        const auto other = triangle_at_.find({to, from});
        if (other == triangle_at_.end() || divided_->kept[other->second] != divided_->kept[t]) {
          ++region.border;
        } else if (!seen[other->second]) {
          seen[other->second] = true;
          region.triangles.push_back(other->second);
        }
      }
    }
    return region;
  }

  DividedPatch* divided_;
  std::map<Side, std::size_t> triangle_at_;  ///< of each side its triangle
};

/// Whether a disc was moved.
bool move_discs(DividedPatch& divided, const std::vector<Loop>& lines, const std::vector<bool>& paired,
                double shallow) {
  std::optional<Discs> discs;
  bool moved = false;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (paired[i]) continue;
    if (!discs) discs.emplace(divided);
    moved = discs->move(lines[i], shallow) || moved;
  }
  return moved;
}

}  // namespace

void agree(DividedPatch& first, DividedPatch& second, double tolerance, double shallow) {
  for (bool moved = true; moved;) {
    const std::vector<Loop> lines = lines_of(first), others = lines_of(second);
    std::vector<bool> paired(lines.size(), false), other_paired(others.size(), false);
    for (const LinePair& pair : pair_lines(first.patch, lines, second.patch, others, tolerance))
      paired[pair.first] = other_paired[pair.second] = true;
    moved = move_discs(first, lines, paired, shallow);
    moved = move_discs(second, others, other_paired, shallow) || moved;
  }
}

}  // namespace burin
