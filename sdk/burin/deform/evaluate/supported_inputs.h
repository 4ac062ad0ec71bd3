#pragma once
#include <burin/abi/stroke.h>

#include <cstdint>
#include <string>

namespace burin {

/// The inputs that this host provides and the outputs that it accepts; a brush that declares others is
/// rejected.
inline constexpr std::uint64_t supported_inputs =
    BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS | BURIN_INPUT_STRETCH | BURIN_INPUT_FOOTPRINT |
    BURIN_INPUT_POSITION | BURIN_INPUT_NORMAL | BURIN_INPUT_E1 | BURIN_INPUT_MEAN_CURVATURE |
    BURIN_INPUT_LAPLACIAN | BURIN_INPUT_DISPLACEMENT | BURIN_INPUT_MASK | BURIN_INPUT_COLOUR |
    BURIN_INPUT_SHEET | BURIN_INPUT_VISIT_COUNT | BURIN_INPUT_NODE_ID | BURIN_INPUT_SYMMETRY |
    BURIN_INPUT_PRESSURE | BURIN_INPUT_TILT | BURIN_INPUT_TWIST | BURIN_INPUT_SPEED | BURIN_INPUT_TIME |
    BURIN_INPUT_FOOT | BURIN_INPUT_FINE_POSITION | BURIN_INPUT_FINE_NORMAL | BURIN_INPUT_FINE_MEAN_CURVATURE;
inline constexpr std::uint64_t supported_outputs =
    BURIN_OUTPUT_DISPLACEMENT | BURIN_OUTPUT_MASK | BURIN_OUTPUT_COLOUR;

/// The names of inputs or outputs for messages: "laplacian, mask". An unknown bit is given by its number.
std::string input_names(std::uint64_t inputs);
std::string output_names(std::uint64_t outputs);

}  // namespace burin
