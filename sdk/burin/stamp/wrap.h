#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

namespace burin {

/// What an image is beyond its borders in one direction. The numbers are those of burin_stamp_wrap.
enum class Wrap : std::int32_t {
  unknown = 0,   ///< as the file says; periodic where it says nothing
  periodic = 1,  ///< repeats with period 1
  mirror = 2,    ///< repeats, every other time mirrored
  clamp = 3,     ///< the texel at the border goes on
  black = 4      ///< 0
};

/// "periodic", "mirror", "clamp", "black"; "unknown".
std::string_view wrap_name(Wrap wrap);

/// Wrap::unknown for any other text.
Wrap wrap_named(std::string_view name);

/// Of "periodic,clamp", as texture files have it: u, then v. One word holds for both.
std::pair<Wrap, Wrap> wraps_named(std::string_view names);

constexpr std::ptrdiff_t no_texel = -1;

/// The texel of a row of `size` that stands at any index, or no_texel where the image is black.
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

/// The part of a finite coordinate in its period, 0..1. Without a call of std::floor, which costs more than
/// all the rest of a sample where the machine has no instruction for it.
inline double in_period(float coordinate) {
  constexpr float first_whole = 8388608;  // from here on all floats are whole numbers
  if (!(std::abs(coordinate) < first_whole)) return 0;
  const double whole = static_cast<std::int32_t>(coordinate);
  return coordinate - (coordinate < whole ? whole - 1 : whole);
}

/// A coordinate where an image of this wrap holds the same: in its period, 0..1, or 0..2 where every other
/// one is mirrored; else `margin` beyond 0..1 at most.
inline double wrapped_coordinate(float coordinate, Wrap wrap, double margin) {
  if (wrap == Wrap::periodic) return in_period(coordinate);
  if (wrap == Wrap::mirror) return 2 * in_period(coordinate / 2);
  return std::clamp<double>(coordinate, -margin, 1 + margin);
}

}  // namespace burin
