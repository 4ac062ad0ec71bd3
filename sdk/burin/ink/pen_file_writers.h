#pragma once
#include <burin/stroke/recording.h>

#include <ostream>
#include <span>

namespace burin {

/// Writes the strokes of recordings as InkML: X and Y, T in seconds, F from 0 to 1, OTx, OTy and OR in
/// radians, B1 for the button at the pen's side, as far as each stroke has them; in object space Z, and an
/// annotation that tells so. Strokes whose tool or eraser is known have a brush with the properties `tool`
/// and `eraser`. read_pen_file() reads the same numbers back, but not settings and cameras, nor strokes
/// without samples.
void write_inkml(std::span<const Recording> recordings, std::ostream& out);

/// Writes the strokes as CSV: stroke (from 1), x, y, and z, time (seconds), pressure, tilt_x, tilt_y, twist
/// (radians), barrel, eraser and tool if any stroke has them; a stroke without leaves the cell empty.
/// read_pen_file() reads the same numbers back, but not settings and cameras, nor strokes without samples.
void write_pen_csv(std::span<const Recording> recordings, std::ostream& out);

}  // namespace burin
