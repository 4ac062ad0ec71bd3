#pragma once
#include <burin/host/c/burin.h>
#include <burin/host/c/call.h>
#include <burin/stroke/recording.h>

#include <cstdint>

namespace burin::c {

/// What a pen reports, of bits BURIN_PEN_*.
inline PenFields fields_of(std::uint32_t fields) {
  return {.time = (fields & BURIN_PEN_TIME) != 0,
          .pressure = (fields & BURIN_PEN_PRESSURE) != 0,
          .tilt = (fields & BURIN_PEN_TILT) != 0,
          .twist = (fields & BURIN_PEN_TWIST) != 0,
          .barrel = (fields & BURIN_PEN_BARREL) != 0};
}

/// Passes samples on, completed, and their numbers: they lie one after the other, each of the size that it
/// tells.
template <class Take>
void read_samples(const burin_sample* samples, std::uint64_t count, const Take& take) {
  const char* at = reinterpret_cast<const char*>(samples);
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto* next = reinterpret_cast<const burin_sample*>(at);
    take(known_members(next, BURIN_HAS(next, burin_sample, barrel), "a sample"), i);
    at += next->struct_size;
  }
}

/// The bits BURIN_PEN_* of what a pen reports.
inline std::uint32_t bits_of(const PenFields& fields) {
  std::uint32_t bits = 0;
  if (fields.time) bits |= BURIN_PEN_TIME;
  if (fields.pressure) bits |= BURIN_PEN_PRESSURE;
  if (fields.tilt) bits |= BURIN_PEN_TILT;
  if (fields.twist) bits |= BURIN_PEN_TWIST;
  if (fields.barrel) bits |= BURIN_PEN_BARREL;
  return bits;
}

/// What a struct of C has of a sample beside its position: those fields alone that the pen reports.
template <class Given>
void read_pen(const Given& given, const PenFields& fields, Sample& sample) {
  if (fields.time) sample.time = given.time;
  if (fields.pressure) sample.pen.pressure = given.pressure;
  if (fields.tilt) {
    sample.pen.tilt_x = given.tilt_x;
    sample.pen.tilt_y = given.tilt_y;
  }
  if (fields.twist) sample.pen.twist = given.twist;
  if (fields.barrel) sample.barrel = given.barrel != 0;
}

/// Gives what a sample has beside its position to a struct of C.
template <class Given>
void write_pen(const Sample& from, Given& into) {
  into.time = from.time;
  into.pressure = from.pen.pressure;
  into.tilt_x = from.pen.tilt_x;
  into.tilt_y = from.pen.tilt_y;
  into.twist = from.pen.twist;
  into.barrel = from.barrel ? 1 : 0;
}

}  // namespace burin::c
