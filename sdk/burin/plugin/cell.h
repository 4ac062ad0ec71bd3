#pragma once
#include <burin/plugin/batch.h>

#include <algorithm>
#include <cstddef>

namespace burin::plugin {

/// A node of the chart and its cell: the rectangle of footprint_t x footprint_d around (t, d). A brush must
/// average or leave out details that are finer than the cell. Object units.
struct Cell {
  float t, d, radius;
  float footprint_t, footprint_d;

  /// The larger side.
  float footprint() const { return std::max(footprint_t, footprint_d); }
};

/// The cells of a batch. Needs BURIN_INPUT_T, D, RADIUS and FOOTPRINT.
class Cells {
 public:
  explicit Cells(const Batch& in)  ///< of all nodes
      : t_(in.t()),
        d_(in.d()),
        radius_(in.radius()),
        footprint_t_(in.footprint_t()),
        footprint_d_(in.footprint_d()) {}

  Cell operator[](std::size_t i) const {  ///< of one node
    return {t_[i], d_[i], radius_[i], footprint_t_[i], footprint_d_[i]};
  }

 private:
  Floats t_, d_, radius_, footprint_t_, footprint_d_;
};

}  // namespace burin::plugin
