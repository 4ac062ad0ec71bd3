#pragma once
#include <burin/base/vector.h>
#include <burin/stroke/given_settings.h>

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "input/mesh_input.h"

namespace burin {

/// A stroke made by rule: straight along the surface.
struct StraightStroke {
  std::size_t samples = 0;  ///< equally far apart
  Vec3d from, towards;      ///< begins at the surface point closest to the first; object units
  double length_radii = 0;  ///< in radii of the stroke
};

/// What cases of a suite vary together, so that the growth of their cost can be told.
enum class ScalingAxis {
  none,
  region,  ///< vertices that the stroke reaches
  mesh,    ///< triangles of the surface, the stroke reaching the same number of vertices
};

/// One measurement: strokes drawn on a surface.
struct BenchCase {
  std::string name;
  MeshOptions mesh;
  std::vector<std::string> strokes;        ///< recordings; or, if none:
  std::optional<StraightStroke> straight;  ///< a made stroke
  std::optional<double> radius_edges;      ///< radius in mean edge lengths of the surface
  GivenSettings settings;                  ///< instead of the recorded ones
  std::size_t repeat = 3;
  ScalingAxis axis = ScalingAxis::none;
};

/// A file of cases; docs/bench.md describes it. Paths in it are relative to its folder, here no more.
struct Suite {
  std::string path;
  std::string name;
  std::vector<BenchCase> cases;  ///< at least one, no two of one name
};

/// Throws FileError naming the place of the first fault; files that it names must be there.
Suite read_suite(const std::filesystem::path& path);

const std::map<std::string, ScalingAxis>& scaling_axis_names();

}  // namespace burin
