#pragma once
#include <burin/ink/pen_file_facts.h>
#include <burin/stamp/files/picture.h>
#include <burin/stroke/recording.h>
#include <burin/surface/surface.h>

#include <optional>
#include <string_view>

namespace burin::command {

/// What the colour of a line tells.
enum class LineColour { pressure, speed };

/// The values that strokes have of it, from blue over green to yellow; those above are yellow too. Speed is
/// in units of the positions per second, up to the 95th percentile. Nothing if no stroke has any: its lines
/// are dark then.
std::optional<ValueRange> coloured_range(const Recording& recording, LineColour colour);

/// The strokes on white, as large as they fit; strokes in space as seen along -z.
Picture picture_in_plane(Recording recording, LineColour colour, int width, int height);

/// The strokes over a shaded picture of a surface, as the recording's camera sees them.
Picture picture_on_surface(const Recording& recording, LineColour colour, const Surface& surface);

}  // namespace burin::command
