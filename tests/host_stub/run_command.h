#pragma once
#include <burin/surface/point_set.h>
#include <burin/surface/triangle_mesh.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "support/process.h"
#include "support/shared_data.h"

namespace burin::test {

/// A folder of files for the burin command, and runs of the command.
class CommandFolder {
 public:
  /// The path of a file in the folder.
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

  /// Writes a file and returns its path.
  std::string write(const std::string& name, const std::string& text) const;

  /// Names and sizes of everything in the folder.
  std::set<std::string> content() const;

 private:
  TemporaryFolder folder_;
};

/// Runs `burin ARGUMENTS` with the stock brushes only.
ProcessResult burin(const std::vector<std::string>& arguments);

/// The standard output of a run that must succeed and keep silent on stderr.
std::string burin_output(const std::vector<std::string>& arguments);

/// Runs the command with --json; returns the parsed result.
nlohmann::json burin_json(std::vector<std::string> arguments);

/// The module of one of the faulty plugins in validate/bad_plugins, or of the good one they are made of.
std::string bad_plugin(const std::string& name);

std::string obj_text(const TriangleMesh& mesh);

/// A PLY file of points with normals and no element of faces.
std::string ply_text(const PointSet& points);

/// The cube of half edge 1 as six quads: a cage.
std::string cube_obj();

/// A stroke file in object space with one stroke along the equator (y = 0) of the unit sphere, by the angles
/// from z towards x, radians, 10 ms apart. `settings`: members of "begin", "\"radius\":0.2".
std::string equator_stroke(double from, double to, int samples, const std::string& settings);

/// The lines of that stroke without the header of the file.
std::string equator_stroke_lines(double from, double to, int samples, const std::string& settings);

}  // namespace burin::test
