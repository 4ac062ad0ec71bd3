#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

namespace burin {

/// The values of an image outside its borders in one direction. The numbers are those of burin_stamp_wrap.
enum class Wrap : std::int32_t {
  unknown = 0,   ///< the mode stored in the file, else periodic
  periodic = 1,  ///< the image repeats with period 1
  mirror = 2,    ///< the image repeats, every other copy mirrored
  clamp = 3,     ///< the nearest texel at the border
  black = 4      ///< 0
};

/// The name of a wrap: "unknown", "periodic", "mirror", "clamp" or "black".
std::string_view wrap_name(Wrap wrap);

/// The wrap with this name; Wrap::unknown for any other text.
Wrap parse_wrap(std::string_view name);

/// The wraps in u and v from a text such as "periodic,clamp", which texture files store. A single word holds
/// for both.
std::pair<Wrap, Wrap> parse_wraps(std::string_view names);

constexpr std::ptrdiff_t no_texel = -1;

/// The texel of a row of `size` texels that an index outside of the row refers to, or no_texel where the wrap
/// is black.
inline std::ptrdiff_t wrapped_index(std::ptrdiff_t index, std::ptrdiff_t size, Wrap wrap) {
  if (index >= 0 && index < size) return index;
  switch (wrap) {
    case Wrap::clamp:
      return index < 0 ? 0 : size - 1;
    case Wrap::black:
      return no_texel;
    case Wrap::mirror: {
      const std::ptrdiff_t turned = index % (2 * size), place = turned < 0 ? turned + 2 * size : turned;
      return place < size ? place : 2 * size - 1 - place;
    }
    default: {
      const std::ptrdiff_t rest = index % size;
      return rest < 0 ? rest + size : rest;
    }
  }
}

/// The fractional part of a finite coordinate, 0..1. Does not call std::floor, which costs more than the rest
/// of a sample on processors without an instruction for it.
inline double in_period(float coordinate) {
  constexpr float first_whole = 8388608;  // from here on all floats are whole numbers
  if (!(std::abs(coordinate) < first_whole)) return 0;
  const double whole = static_cast<std::int32_t>(coordinate);
  return coordinate - (coordinate < whole ? whole - 1 : whole);
}

/// An equivalent coordinate in the first period of an image: 0..1 for a periodic wrap, 0..2 for a mirrored
/// one. For the other wraps it is clamped to at most `margin` outside 0..1.
inline double wrapped_coordinate(float coordinate, Wrap wrap, double margin) {
  if (wrap == Wrap::periodic) return in_period(coordinate);
  if (wrap == Wrap::mirror) return 2 * in_period(coordinate / 2);
  return std::clamp<double>(coordinate, -margin, 1 + margin);
}

}  // namespace burin
