#pragma once
#include <burin/base/vector.h>

#include <optional>
#include <string>

#include "cli_fwd.h"

namespace burin {

/// Which way is up in a file. In each of these x points to the right and the axes are right-handed.
enum class Axes {
  as_is,  ///< not known; nothing is turned
  y_up,
  z_up,
};

/// The axes of the files of a command, as the command line names them. Strokes are drawn in those of the mesh
/// file, which all other options are in, too.
struct AxesOptions {
  Axes mesh = Axes::as_is;     ///< glTF is y-up unless told otherwise
  std::optional<Axes> saved;   ///< those of the mesh unless given; y-up of glTF where those are given
  Axes strokes = Axes::as_is;  ///< those of the mesh
};

/// Adds --axes MESH[:SAVED] and --stroke-axes.
void add_axes_options(CLI::App& command, AxesOptions& options);

/// Adds --axes MESH and --stroke-axes, for a command that saves no mesh.
void add_drawing_axes_options(CLI::App& command, AxesOptions& options);

/// Turns places and directions of recordings to those of the mesh file, or of that to those of the file to be
/// saved: by a right angle about x, so that coordinates are exchanged and negated only. Throw Error where the
/// axes of the mesh file would have to be known.
Eigen::Matrix3d turn_of_strokes(const AxesOptions& options, const std::string& mesh_path);
Eigen::Matrix3d turn_of_saved(const AxesOptions& options, const std::string& mesh_path,
                              const std::string& saved_path);

}  // namespace burin
