#pragma once
#include <burin/abi/base.h>
#include <burin/plugin/c/compositing.h>

#include <cstddef>
#include <cstdint>

namespace burin::plugin {

/// A read-only view of one quantity for the elements of a batch, uniform or varying. It points into the
/// host's buffers and is valid until evaluate(), or the constructor that received it, returns.
template <class Stored, class Value = Stored>
class View {
 public:
  View(const Stored* data, std::size_t stride) : data_(data), stride_(stride) {}

  Value operator[](std::size_t element) const { return static_cast<Value>(data_[element * stride_]); }

  /// The value of a quantity that does not vary: a parameter that is not dynamic, or any number in a
  /// constructor.
  Value value() const { return (*this)[0]; }

 private:
  const Stored* data_;
  std::size_t stride_;
};

using Floats = View<float>;
using Indices = View<std::uint32_t>;
using Ints = View<float, int>;
using Bools = View<float, bool>;

/// A view of an output, one element per node. It points into the host's buffers and is valid during
/// evaluate().
class FloatsOut {
 public:
  FloatsOut(float* data, std::size_t stride) : data_(data), stride_(stride) {}

  float& operator[](std::size_t element) const { return data_[element * stride_]; }

  /// The elements from `first` on.
  FloatsOut from(std::size_t first) const { return {data_ + first * stride_, stride_}; }

  burin_floats_out raw() const { return {data_, static_cast<std::uint32_t>(stride_), 0}; }

 private:
  float* data_;
  std::size_t stride_;
};

/// Vectors as three arrays of components.
struct Vectors {
  Floats x, y, z;
};

/// Colours as four arrays: linear RGB and coverage, each 0..1.
struct Colours {
  Floats r, g, b, a;
};

/// Colours to write: linear RGB and coverage, each 0..1.
struct ColoursOut {
  FloatsOut r, g, b, a;

  /// Lays an ink over the colour of an element by the operator "over" [Porter and Duff 1984]. `share` (0..1)
  /// says how much of the ink there is: 0 leaves the colour as it is. See burin/plugin/c/compositing.h.
  void composite_over(std::size_t element, const Colours& ink, float share) const {
    const burin_floats_out rgba[4] = {r.raw(), g.raw(), b.raw(), a.raw()};
    const float one[4] = {ink.r[element], ink.g[element], ink.b[element], ink.a[element]};
    burin_composite_over(rgba, static_cast<std::uint32_t>(element), one, share);
  }
};

}  // namespace burin::plugin
