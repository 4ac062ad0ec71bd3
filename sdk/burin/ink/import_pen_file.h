#pragma once
#include <burin/ink/pen_file.h>
#include <burin/ink/pen_strokes.h>
#include <burin/stroke/recording.h>
#include <burin/surface/surface.h>

#include <filesystem>
#include <optional>

namespace burin {

/// Where the strokes of a drawing are put.
enum class PenFit {
  view,  ///< they fill the view, with a margin of a tenth, whether or not the surface is there
  mesh,  ///< as large as possible with every sample on the surface as the camera sees it
};

/// How a pen file is imported. What the file lacks stays absent unless it is asked for.
struct PenImport {
  PenChoice choice = {};
  PenFit fit = PenFit::view;
  /// Speed of the pen in strokes without times: pixels per second, or object units of strokes in space.
  std::optional<double> speed = {};
  bool pressure_from_width = false;  ///< see press_by_width()
};

/// Counts of what an import changed or left out.
struct ImportCounts {
  std::size_t events = 0;        ///< events in the file
  std::size_t lifted = 0;        ///< events left out since the pen did not touch the tablet
  std::size_t times_raised = 0;  ///< samples whose time was raised since it fell within a stroke
  /// Strokes that lost their pressure since the file has pressure 0 in contact everywhere.
  std::size_t pressures_dropped = 0;
  std::size_t estimated_y = 0;  ///< strokes whose y the file does not tell, see PenStroke::estimated_y
};

/// An imported recording.
struct Import {
  Recording recording;
  ImportCounts counts;
};

/// Makes strokes of a camera's view of a pen file: its positions scaled uniformly and moved as `fit` tells.
/// Strokes in space become strokes in object space: those of a known unit are scaled uniformly and moved so
/// that their bounding box fits into that of the surface, others are in object units; then each sample goes
/// to the nearest place of the surface. Times count from the first sample of the file; one that falls within
/// a stroke is raised to the time before it. Brush and radius stay unset. `path` is for messages. Throws
/// FileError for a file without a stroke that is wanted, for PenFit::mesh where the camera sees no surface,
/// and for times asked for that are too long; ContractError for a camera with an empty viewport or without an
/// inverse.
Import import_pen_file(const std::filesystem::path& path, PenFile file, const PenImport& options,
                       const Camera& camera, const Surface& surface);

}  // namespace burin
