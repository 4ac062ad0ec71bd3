#pragma once
#include <burin/stroke/symmetry.h>
#include <burin/surface/picker.h>

#include <algorithm>
#include <cmath>

#include "sessions.h"

namespace burin::test {

/// A session of a mesh that has a symmetry, whose images of vertices are vertices.
class SymmetricSession {
 public:
  SymmetricSession(TriangleMesh mesh, const SymmetryInstance& image)
      : session(make_surface(std::move(mesh)), test::brushes()), base(session.surface().positions) {
    const Picker picker(session.surface());
    for (const Vec3f& place : base) {
      const auto at = picker.closest(image(place.cast<double>()).cast<float>(), 0.1f);
      const auto nearest = std::ranges::max_element(at->weights) - at->weights.begin();
      image_of.push_back(at->corners[static_cast<std::size_t>(nearest)]);
    }
  }

  /// The greatest distance of the image of a vertex from the position that the symmetry gives.
  double worst(const SymmetryInstance& image) const {
    double worst = 0;
    for (Index vertex = 0; vertex < base.size(); ++vertex) {
      const Vec3d expected = image(session.positions()[vertex].cast<double>());
      worst = std::max(worst, (expected - session.positions()[image_of[vertex]].cast<double>()).norm());
    }
    return worst;
  }
  std::size_t moved() const {
    std::size_t count = 0;
    for (Index vertex = 0; vertex < base.size(); ++vertex)
      count += session.positions()[vertex] != base[vertex];
    return count;
  }

  Session session;
  std::vector<Vec3f> base;
  std::vector<Index> image_of;
};

/// An octahedron whose triangles are split, on the unit sphere: symmetric in all axes, and by quarter turns.
inline TriangleMesh octahedral_sphere(int cells) {
  TriangleMesh mesh;
  for (int face = 0; face < 8; ++face) {
    const float x = face & 1 ? -1 : 1, y = face & 2 ? -1 : 1, z = face & 4 ? -1 : 1;
    const bool flip = x * y * z < 0;
    std::vector<std::vector<Index>> rows;
    for (int i = 0; i <= cells; ++i) {
      rows.emplace_back();
      for (int j = 0; j <= cells - i; ++j) {
        const auto a = static_cast<float>(i), b = static_cast<float>(j),
                   c = static_cast<float>(cells - i - j);
        const Vec3f place = Vec3f(x * a, y * b, z * c).normalized();
        const auto known = std::ranges::find(mesh.positions, place);
        rows.back().push_back(static_cast<Index>(known - mesh.positions.begin()));
        if (known == mesh.positions.end()) mesh.positions.push_back(place);
      }
    }
    const auto add = [&](Index p, Index q, Index r) {
      mesh.triangles.push_back(flip ? Triangle{p, r, q} : Triangle{p, q, r});
    };
    for (std::size_t i = 0; i + 1 < rows.size(); ++i)
      for (std::size_t j = 0; j + 1 < rows[i].size(); ++j) {
        add(rows[i][j], rows[i + 1][j], rows[i][j + 1]);
        if (j + 2 < rows[i].size()) add(rows[i + 1][j], rows[i + 1][j + 1], rows[i][j + 1]);
      }
  }
  return mesh;
}

/// Samples around the y axis from one angle to another, on the unit sphere.
inline std::vector<Sample> arc(double from, double to, double height) {
  std::vector<Sample> samples;
  for (int i = 0; i <= 30; ++i) {
    const double angle = from + (to - from) * i / 30;
    Sample sample;
    sample.time = 0.01 * i;
    sample.position =
        Vec3d(std::cos(angle), height + 0.1 * std::sin(3 * angle), std::sin(angle)).normalized();
    samples.push_back(sample);
  }
  return samples;
}

}  // namespace burin::test
