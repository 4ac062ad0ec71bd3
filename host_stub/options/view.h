#pragma once
#include <burin/stroke/camera.h>
#include <burin/stroke/curve/surface_curve.h>
#include <burin/surface/surface.h>

#include <optional>
#include <span>

#include "cli_fwd.h"

namespace burin {

/// How a command is to look at its surface.
struct ViewOptions {
  std::optional<Vec3d> direction;  ///< of sight; left open, the command chooses
  std::optional<Vec3d> up;         ///< y unless given
  double field_of_view = 35;       ///< vertical, degrees
  int width = 1000, height = 750;  ///< pixels
};

/// Adds --view, --up, --fov, --width and --height.
void add_view_options(CLI::App& command, ViewOptions& options);

/// Shows the whole surface: along the direction of the options, or from the front, above and to the right.
Camera whole_view(const Surface& surface, const ViewOptions& options);

/// Shows strokes of this radius: along the direction of the options, or against the mean normal.
/// `curves` hold at least one point, else the view is the whole one.
Camera stroke_view(const Surface& surface, std::span<const SurfaceCurve> curves, double radius,
                   const ViewOptions& options);

/// The same view with a viewport of at most `longest` pixels on its longer side.
Camera fit_into(Camera camera, int longest);

}  // namespace burin
