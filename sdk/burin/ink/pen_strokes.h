#pragma once
#include <burin/ink/pen_file.h>
#include <burin/stroke/recording.h>

#include <optional>

namespace burin {

/// Which strokes of a pen file are wanted; all if nothing is given.
struct PenChoice {
  std::optional<std::size_t> page, layer;  ///< from 1
};

/// Removes the strokes that are not wanted.
void keep_chosen(PenFile& file, const PenChoice& choice);

/// Gives the strokes that have widths and no pressure the width at each sample, as a share of the greatest
/// one in the file, for pressure.
void press_by_width(PenFile& file);

/// The strokes as the file has them, in its units and times, without cameras and settings. In object space if
/// all strokes lie in space, else in screen space, where z is 0. Pages, layers and widths are left out.
Recording recording_of(PenFile file);

/// A recording as if it had been read as a pen file of the kind "stroke".
PenFile pen_file_of(const Recording& recording);

}  // namespace burin
