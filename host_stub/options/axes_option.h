#pragma once
#include <burin/base/vector.h>

#include <optional>
#include <string>

#include "cli_fwd.h"

namespace burin {

/// The up axis of a file. x points to the right and axes are right-handed in every case.
enum class Axes {
  as_is,  ///< unknown; nothing is rotated
  y_up,
  z_up,
};

/// The axes of the files of a command, from the command line. Strokes are drawn in the axes of the mesh file,
/// and all other options refer to these.
struct AxesOptions {
  Axes mesh = Axes::as_is;     ///< axes of the mesh file; as_is means y-up for glTF
  std::optional<Axes> saved;   ///< axes of the saved file; by default those of the mesh, or y-up for glTF
  Axes strokes = Axes::as_is;  ///< axes of the recordings; as_is means those of the mesh
};

/// Adds --axes MESH[:SAVED] and --stroke-axes.
void add_axes_options(CLI::App& command, AxesOptions& options);

/// Adds --axes MESH and --stroke-axes, for a command that saves no mesh.
void add_drawing_axes_options(CLI::App& command, AxesOptions& options);

/// The rotation from the axes of recordings to those of the mesh file, and from those of the mesh file to
/// those of the saved file: the identity, or a right angle about x, which only exchanges and negates
/// coordinates. Throw Error if the axes of the mesh file are needed but unknown.
Eigen::Matrix3d turn_of_strokes(const AxesOptions& options, const std::string& mesh_path);
Eigen::Matrix3d turn_of_saved(const AxesOptions& options, const std::string& mesh_path,
                              const std::string& saved_path);

}  // namespace burin
