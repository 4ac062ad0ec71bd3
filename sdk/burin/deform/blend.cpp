#include <burin/base/parallel.h>
#include <burin/deform/blend.h>
#include <burin/deform/displacement.h>
#include <burin/deform/first_failure.h>

#include <algorithm>
#include <cstddef>

namespace burin {
namespace {

/// The nodes of a vertex.
class Sheets {
 public:
  Sheets(const Surface& surface, const LiveChart& chart, std::span<const Vec3f> displacement, Index vertex)
      : chart_(chart),
        displacement_(displacement),
        base_(surface.positions[vertex]),
        normal_(surface.normals[vertex]),
        vertex_(vertex),
        first_(chart.first(vertex)) {}

  Vec3f blended(Overlap overlap) const;

 private:
  Vec3f place(Index slot) const {
    return displaced(base_, chart_.nodes().e1[slot], normal_, displacement_[slot]);
  }
  bool farther_out(Index a, Index b) const;
  Index winner(Overlap overlap) const;
  Vec3d sum() const;

  const LiveChart& chart_;
  std::span<const Vec3f> displacement_;
  const Vec3f &base_, &normal_;
  Index vertex_, first_;
};

/// By the displacement along the normal; ties by where the vertex would go, whatever the order of sheets.
bool Sheets::farther_out(Index a, Index b) const {
  const float up_a = displacement_[a].z(), up_b = displacement_[b].z();
  if (up_a != up_b) return up_a > up_b;
  const Vec3f place_a = place(a), place_b = place(b);
  return std::lexicographical_compare(place_b.begin(), place_b.end(), place_a.begin(), place_a.end());
}

Index Sheets::winner(Overlap overlap) const {
  Index best = first_;
  for (Index slot = chart_.next(first_); slot != no_index; slot = chart_.next(slot)) {
    const bool better = overlap == Overlap::latest || (overlap == Overlap::max && farther_out(slot, best)) ||
                        (overlap == Overlap::min && farther_out(best, slot));
    if (better) best = slot;
  }
  return best;
}

/// Of all sheets, in object space; in doubles, so that floats cannot tell in which order it was taken.
Vec3d Sheets::sum() const {
  const Vec3d n = normal_.cast<double>();
  Vec3d total = Vec3d::Zero();
  for (Index slot = first_; slot != no_index; slot = chart_.next(slot)) {
    const Vec3d e1 = chart_.nodes().e1[slot].cast<double>(), part = displacement_[slot].cast<double>();
    total += e1 * part.x() + n.cross(e1) * part.y() + n * part.z();
  }
  return total;
}

Vec3f Sheets::blended(Overlap overlap) const {
  if (first_ == no_index) return base_;
  const bool one = chart_.next(first_) == no_index;
  if (one || (overlap != Overlap::add && overlap != Overlap::average)) return place(winner(overlap));
  const Vec3d total = overlap == Overlap::add ? sum() : Vec3d(sum() / chart_.sheet_count(vertex_));
  if (total.isZero(0)) return base_;
  return (base_.cast<double>() + total).cast<float>();
}

}  // namespace

void blend_sheets(const Surface& surface, const LiveChart& chart, std::span<const Vec3f> displacement,
                  std::span<const Index> vertices, Overlap overlap, std::string_view brush,
                  std::span<Vec3f> places) {
  FirstFailure failure;
  parallel_blocks(vertices.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      places[i] = Sheets(surface, chart, displacement, vertices[i]).blended(overlap);
      if (!places[i].allFinite()) return failure.note(i, "displaces beyond the range of floats");
    }
  });
  if (failure.any()) failure.throw_at(brush, chart.nodes(), chart.first(vertices[failure.element()]));
}

}  // namespace burin
