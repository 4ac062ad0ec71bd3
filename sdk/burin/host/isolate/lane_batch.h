#pragma once
#include <burin/host/isolate/shared_memory.h>

#include <cstddef>

namespace burin::isolate {

/// A call for a batch, in the host's memory. Structs are complete: members that the caller does not know are
/// zero.
struct BatchCall {
  Batch what = Batch::evaluate;
  std::uint32_t stroke = 0;
  burin_stroke_context context{};
  burin_batch batch{};
  burin_outputs outputs{};
  burin_floats height{};        ///< of distance()
  burin_floats_out distance{};  ///< of distance()
};

/// Where a lane has what the brush writes.
struct PackedOutputs {
  std::array<Column, output_arrays> outputs;
  Column distance;
};

/// How many elements of the call fit a lane, at least 1. Throws Error if not even one does.
std::size_t elements_that_fit(const BatchCall& call);

/// Copies the elements [first, first + count) into a lane, and what outputs hold before the call.
PackedOutputs pack(const BatchCall& call, std::size_t first, std::size_t count, std::byte* lane);

/// Copies what the brush wrote for them out of the lane.
void unpack(const PackedOutputs& packed, const std::byte* lane, const BatchCall& call, std::size_t first,
            std::size_t count);

}  // namespace burin::isolate
