// Puts a patch into a surface: what the surface has is copied with the numbers that are left, and only around
// the patch neighbourhoods, normals and curvature are made anew. Costs O(n) of copying, and O(k log k) for
// the k triangles of the patch.
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/surface/geometry/curvature.h>
#include <burin/surface/geometry/normals.h>
#include <burin/surface/geometry/triangle_shape.h>
#include <burin/surface/surface_patch.h>
#include <burin/surface/topology/spatial_order.h>

#include <algorithm>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

namespace burin {
namespace {

constexpr std::size_t elements_per_block = 16384;

/// Calls body(begin, end) for blocks of indices on all threads.
template <class Body>
void for_blocks(std::size_t count, const Body& body) {
  parallel_blocks(count, elements_per_block, [&](std::size_t begin, std::size_t end) {
    body(static_cast<Index>(begin), static_cast<Index>(end));
  });
}

/// The numbers that remain when some of the numbers, ascending, are left out. Remembers where the last one
/// was found, since the next one is near.
class Remaining {
 public:
  explicit Remaining(const std::vector<Index>& left_out) : left_out_(&left_out) {}

  /// The new number of one that is not left out.
  Index operator()(Index number) {
    if (number < low_ || number >= high_) find(number);
    return number - below_;
  }

 private:
  void find(Index number) {
    const auto above = std::ranges::upper_bound(*left_out_, number);
    below_ = static_cast<Index>(above - left_out_->begin());
    low_ = above == left_out_->begin() ? 0 : *(above - 1) + 1;
    high_ = above == left_out_->end() ? no_index : *above;
  }

  const std::vector<Index>* left_out_;
  Index low_ = 0, high_ = 0, below_ = 0;
};

void sort_unique(std::vector<Index>& numbers) {
  parallel_sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

/// Makes the surface with the patch.
class Patcher {
 public:
  Patcher(const Surface& before, const SurfacePatch& patch)
      : before_(before), patch_(patch), old_count_(before.vertex_count()) {
    if (!std::ranges::all_of(patch.positions, [](const Vec3f& p) { return p.allFinite(); }))
      throw Error("a vertex has a coordinate that is not finite");
  }

  PatchedSurface run() {
    find_vertices();
    take_vertices();
    take_triangles();
    if (made_.triangles.empty()) throw Error("no triangle is left of the surface");
    find_changed();
    made_.incident = with_rows(before_.incident, incident_, patch_.removed);
    made_.neighbours = with_rows(before_.neighbours, neighbours_, gone_);
    shape();
    made_.scale = before_.scale;
    return {std::move(made_), std::move(came_from_)};
  }

 private:
  bool is_removed(Index triangle) const { return std::ranges::binary_search(patch_.removed, triangle); }

  /// Which vertices are gone, and which of the new ones are used.
  void find_vertices() {
    for (const Triangle& t : patch_.triangles)
      if (!has_repeated_vertex(t)) used_.insert(used_.end(), t.begin(), t.end());
    sort_unique(used_);
    for (const Index t : patch_.removed)
      around_.insert(around_.end(), before_.triangles[t].begin(), before_.triangles[t].end());
    sort_unique(around_);
    for (const Index v : around_) {
      const auto removed = [this](Index t) { return is_removed(t); };
      if (!std::ranges::binary_search(used_, v) && std::ranges::all_of(before_.incident[v], removed))
        gone_.push_back(v);
    }
    kept_count_ = old_count_ - static_cast<Index>(gone_.size());
  }

  /// The old ones that are left in their order, then new ones along a curve that fills space.
  void take_vertices() {
    const std::span<const Index> fresh(std::ranges::lower_bound(used_, old_count_), used_.end());
    std::vector<Vec3f> positions;
    for (const Index v : fresh) positions.push_back(patch_.positions[v - old_count_]);
    const std::vector<Index> order = spatial_order(positions);
    number_of_new_.resize(patch_.positions.size(), no_index);
    came_from_.resize(kept_count_ + fresh.size());
    made_.positions.resize(came_from_.size());
    made_.source_vertex.resize(came_from_.size());
    copy_vertices();
    for (std::size_t i = 0; i < order.size(); ++i) {
      const auto at = kept_count_ + static_cast<Index>(i);
      number_of_new_[fresh[order[i]] - old_count_] = at;
      came_from_[at] = fresh[order[i]];
      made_.positions[at] = positions[order[i]];
      made_.source_vertex[at] = kept_count_ + order[i];
    }
  }

  void copy_vertices() {
    std::vector<Index> gone_sources;
    for (const Index v : gone_) gone_sources.push_back(before_.source_vertex[v]);
    std::ranges::sort(gone_sources);
    for_blocks(old_count_, [&](Index begin, Index end) {
      Remaining number(gone_), source(gone_sources);
      auto next = std::ranges::lower_bound(gone_, begin);
      for (Index v = begin; v < end; ++v) {
        if (next != gone_.end() && *next == v) {
          ++next;
          continue;
        }
        const Index at = number(v);
        came_from_[at] = v;
        made_.positions[at] = before_.positions[v];
        made_.source_vertex[at] = source(before_.source_vertex[v]);
      }
    });
  }

  Triangle numbered(Triangle triangle, Remaining& number) const {
    for (Index& v : triangle) v = v < old_count_ ? number(v) : number_of_new_[v - old_count_];
    return triangle;
  }

  /// The old ones that are left in their order, then new ones by their lowest vertex.
  void take_triangles() {
    const std::vector<Index> order = sorted_new_triangles();
    const std::size_t kept = before_.triangles.size() - patch_.removed.size();
    made_.triangles.resize(kept + order.size());
    const bool has_uv = !before_.triangle_uv.empty();
    if (has_uv) made_.triangle_uv.resize(made_.triangles.size());
    for_blocks(before_.triangles.size(), [&](Index begin, Index end) {
      Remaining number(gone_), triangle(patch_.removed);
      auto next = std::ranges::lower_bound(patch_.removed, begin);
      for (Index t = begin; t < end; ++t) {
        if (next != patch_.removed.end() && *next == t) {
          ++next;
          continue;
        }
        made_.triangles[triangle(t)] = numbered(before_.triangles[t], number);
        if (has_uv) made_.triangle_uv[triangle(t)] = before_.triangle_uv[t];
      }
    });
    for (std::size_t i = 0; i < order.size(); ++i) {
      made_.triangles[kept + i] = new_triangles_[order[i]];
      if (has_uv) made_.triangle_uv[kept + i] = patch_.triangle_uv[order[i]];
    }
  }

  /// Sets `new_triangles_`; those that have no vertex twice, in their order.
  std::vector<Index> sorted_new_triangles() {
    Remaining number(gone_);
    std::vector<Index> order;
    for (const Triangle& t : patch_.triangles) {
      if (!has_repeated_vertex(t)) order.push_back(static_cast<Index>(new_triangles_.size()));
      new_triangles_.push_back(has_repeated_vertex(t) ? t : numbered(t, number));
    }
    const auto key = [this](Index i) {
      const Triangle& t = new_triangles_[i];
      return std::tuple(std::ranges::min(t), t, i);
    };
    std::ranges::sort(order, {}, key);
    return order;
  }

  /// The vertices whose triangles are others now, with these and with their neighbours.
  void find_changed() {
    used_.insert(used_.end(), around_.begin(), around_.end());
    sort_unique(used_);
    Remaining number(gone_);
    for (const Index v : used_)
      if (v >= old_count_)
        changed_.push_back(number_of_new_[v - old_count_]);
      else if (!std::ranges::binary_search(gone_, v))
        changed_.push_back(number(v));
    std::ranges::sort(changed_);
    incident_.resize(changed_.size());
    neighbours_.resize(changed_.size());
    for (std::size_t i = 0; i < changed_.size(); ++i)
      take_old_triangles(came_from_[changed_[i]], incident_[i]);
    for (auto t = static_cast<Index>(before_.triangles.size() - patch_.removed.size());
         t < made_.triangles.size(); ++t)
      for (const Index v : made_.triangles[t])
        incident_[static_cast<std::size_t>(std::ranges::lower_bound(changed_, v) - changed_.begin())]
            .push_back(t);
    for (std::size_t i = 0; i < changed_.size(); ++i) {
      for (const Index t : incident_[i])
        for (const Index v : made_.triangles[t])
          if (v != changed_[i]) neighbours_[i].push_back(v);
      std::ranges::sort(neighbours_[i]);
      neighbours_[i].erase(std::unique(neighbours_[i].begin(), neighbours_[i].end()), neighbours_[i].end());
    }
  }

  void take_old_triangles(Index vertex, std::vector<Index>& triangles) const {
    if (vertex >= old_count_) return;
    Remaining number(patch_.removed);
    for (const Index t : before_.incident[vertex])
      if (!is_removed(t)) triangles.push_back(number(t));
  }

  /// The old rows of vertices that are left, with these items of theirs left out of the numbers, and other
  /// rows for vertices that changed.
  Csr with_rows(const Csr& old, const std::vector<std::vector<Index>>& rows,
                const std::vector<Index>& left_out) const {
    Csr made;
    const std::size_t count = came_from_.size();
    made.offsets.resize(count + 1);
    for_rows([&](Index v, std::size_t change) {
      made.offsets[v + 1] =
          static_cast<Index>(change == none ? old[came_from_[v]].size() : rows[change].size());
    });
    std::inclusive_scan(made.offsets.begin(), made.offsets.end(), made.offsets.begin());
    made.items.resize(made.offsets.back());
    for_blocks(count, [&](Index begin, Index end) {
      Remaining number(left_out);
      for_rows_of(begin, end, [&](Index v, std::size_t change) {
        auto to = made.items.begin() + made.offsets[v];
        if (change != none)
          std::ranges::copy(rows[change], to);
        else
          for (const Index item : old[came_from_[v]]) *to++ = number(item);
      });
    });
    return made;
  }

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  /// Calls visit(vertex, place in `changed_` or none) for all vertices on all threads.
  void for_rows(const auto& visit) const {
    for_blocks(came_from_.size(), [&](Index begin, Index end) { for_rows_of(begin, end, visit); });
  }

  void for_rows_of(Index begin, Index end, const auto& visit) const {
    auto next = static_cast<std::size_t>(std::ranges::lower_bound(changed_, begin) - changed_.begin());
    for (Index v = begin; v < end; ++v) {
      const bool changed = next < changed_.size() && changed_[next] == v;
      visit(v, changed ? next++ : none);
    }
  }

  /// Normals follow from the triangles around a vertex, curvature from these and the normals of its
  /// neighbours.
  void shape() {
    made_.normals.resize(came_from_.size());
    made_.gauss_curvature.resize(came_from_.size());
    for_rows([&](Index v, std::size_t change) {
      if (change != none) return;
      made_.normals[v] = before_.normals[came_from_[v]];
      made_.gauss_curvature[v] = before_.gauss_curvature[came_from_[v]];
    });
    update_normals(made_, made_.positions, changed_, made_.normals);
    std::vector<Index> curved = changed_;
    for (const Index v : changed_)
      curved.insert(curved.end(), made_.neighbours[v].begin(), made_.neighbours[v].end());
    sort_unique(curved);
    update_gauss_curvature(made_, curved);
  }

  const Surface& before_;
  const SurfacePatch& patch_;
  Index old_count_, kept_count_ = 0;
  std::vector<Index> around_;         ///< corners of removed triangles, ascending
  std::vector<Index> used_;           ///< corners of new triangles, in the patch's numbers; ascending
  std::vector<Index> gone_;           ///< vertices that no triangle has any more, ascending
  std::vector<Index> number_of_new_;  ///< [new vertex]
  std::vector<Triangle> new_triangles_;
  std::vector<Index> came_from_;
  std::vector<Index> changed_;                             ///< vertices whose triangles are others, ascending
  std::vector<std::vector<Index>> incident_, neighbours_;  ///< of those
  Surface made_;
};

}  // namespace

PatchedSurface patched(const Surface& surface, const SurfacePatch& patch) {
  return Patcher(surface, patch).run();
}

}  // namespace burin
