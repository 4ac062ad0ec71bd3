#pragma once
#include <burin/host/recorder.h>
#include <burin/stroke/pen.h>

#include <cstdint>

namespace burin::c {

/// What a pen reports, of bits BURIN_PEN_*.
inline PenFields fields_of(std::uint32_t fields) {
  return {.time = (fields & BURIN_PEN_TIME) != 0,
          .pressure = (fields & BURIN_PEN_PRESSURE) != 0,
          .tilt = (fields & BURIN_PEN_TILT) != 0,
          .twist = (fields & BURIN_PEN_TWIST) != 0};
}

/// The time and pen of a sample, a struct of C: those fields alone that the pen reports.
template <class Given>
void read_pen(const Given& given, const PenFields& fields, double& time, Pen& pen) {
  if (fields.time) time = given.time;
  if (fields.pressure) pen.pressure = given.pressure;
  if (fields.tilt) {
    pen.tilt_x = given.tilt_x;
    pen.tilt_y = given.tilt_y;
  }
  if (fields.twist) pen.twist = given.twist;
}

}  // namespace burin::c
