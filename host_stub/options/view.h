#pragma once
#include <burin/base/vector.h>
#include <burin/stroke/camera.h>
#include <burin/stroke/curve/surface_curve.h>
#include <burin/stroke/recording.h>
#include <burin/surface/surface.h>

#include <optional>
#include <span>

#include "cli_fwd.h"

namespace burin {

/// The view of a surface, from the command line.
struct ViewOptions {
  std::optional<Vec3d> direction;  ///< direction of sight; the command chooses if not given
  std::optional<Vec3d> up;         ///< default: y
  double field_of_view = 35;       ///< vertical, degrees
  int width = 1000, height = 750;  ///< pixels
};

/// Adds --view, --up, --fov, --width and --height.
void add_view_options(CLI::App& command, ViewOptions& options);

/// A camera that shows the whole surface along the direction of the options, or from the front, above and to
/// the right.
Camera whole_view(const Surface& surface, const ViewOptions& options);

/// A camera that shows strokes with this radius along the direction of the options, or against the mean
/// normal. If `curves` have no point it shows the whole surface.
Camera stroke_view(const Surface& surface, std::span<const SurfaceCurve> curves, double radius,
                   const ViewOptions& options);

/// The camera with a viewport of at most `longest` pixels on its longer side.
Camera fit_into(Camera camera, int longest);

/// The camera of the first recording of a screen, with a viewport of at most options.width pixels on its
/// longer side, if there is one and the options ask for no direction; else stroke_view().
Camera recorded_view(std::span<const Recording> recordings, const Surface& surface,
                     std::span<const SurfaceCurve> curves, double radius, const ViewOptions& options);

}  // namespace burin
