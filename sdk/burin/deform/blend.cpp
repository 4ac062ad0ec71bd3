#include <burin/base/parallel.h>
#include <burin/deform/blend.h>
#include <burin/deform/displacement.h>
#include <burin/deform/first_failure.h>
#include <burin/deform/stroke_nodes.h>

#include <algorithm>
#include <cstddef>

namespace burin {
namespace {

/// The nodes [first, end) of a vertex.
struct Sheets {
  const Surface& surface;
  const Chart& chart;
  std::span<const Vec3f> displacement;
  Index first, end;

  const Vec3f& base() const { return surface.positions[chart.vertex[first]]; }
  const Vec3f& normal() const { return surface.normals[chart.vertex[first]]; }
  Vec3f place(Index node) const { return displaced(base(), chart.e1[node], normal(), displacement[node]); }
  bool farther_out(Index a, Index b) const;
  Index winner(Overlap overlap) const;
  Vec3d sum() const;
  Vec3f blended(Overlap overlap) const;
};

/// By the displacement along the normal; ties by where the vertex would go, whatever the order of sheets.
bool Sheets::farther_out(Index a, Index b) const {
  const float up_a = displacement[a].z(), up_b = displacement[b].z();
  if (up_a != up_b) return up_a > up_b;
  const Vec3f place_a = place(a), place_b = place(b);
  return std::lexicographical_compare(place_b.begin(), place_b.end(), place_a.begin(), place_a.end());
}

Index Sheets::winner(Overlap overlap) const {
  Index best = end - 1;
  if (overlap == Overlap::latest) return best;
  for (Index node = first; node + 1 < end; ++node) {
    const bool better = overlap == Overlap::max ? farther_out(node, best) : farther_out(best, node);
    if (better) best = node;
  }
  return best;
}

/// Of all sheets, in object space; in doubles, so that floats cannot tell in which order it was taken.
Vec3d Sheets::sum() const {
  const Vec3d n = normal().cast<double>();
  Vec3d total = Vec3d::Zero();
  for (Index node = first; node < end; ++node) {
    const Vec3d e1 = chart.e1[node].cast<double>(), part = displacement[node].cast<double>();
    total += e1 * part.x() + n.cross(e1) * part.y() + n * part.z();
  }
  return total;
}

Vec3f Sheets::blended(Overlap overlap) const {
  const Index count = end - first;
  if (count == 1 || (overlap != Overlap::add && overlap != Overlap::average)) return place(winner(overlap));
  const Vec3d total = overlap == Overlap::add ? sum() : Vec3d(sum() / count);
  if (total.isZero(0)) return base();
  return (base().cast<double>() + total).cast<float>();
}

}  // namespace

void blend_sheets(const Surface& surface, const Chart& chart, std::span<const Vec3f> displacement,
                  std::span<const Index> firsts, Overlap overlap, std::string_view brush,
                  std::span<Vec3f> places) {
  FirstFailure failure;
  parallel_blocks(firsts.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Sheets sheets{surface, chart, displacement, firsts[i], sheets_end(chart, firsts[i])};
      places[i] = sheets.blended(overlap);
      if (!places[i].allFinite()) return failure.note(i, "displaces beyond the range of floats");
    }
  });
  failure.throw_if_any(brush, chart, firsts);
}

}  // namespace burin
