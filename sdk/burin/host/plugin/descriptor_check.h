#pragma once
#include <burin/abi/brush.h>

#include <string>

namespace burin {

/// The greatest absolute value of INT parameters, 2^24: floats represent every whole number up to it.
inline constexpr float largest_whole_param = 16777216;

/// Checks the contract of burin_brush_descriptor. Returns a one-line error message, or an empty string.
std::string descriptor_problem(const burin_brush_descriptor& descriptor);

/// Checks the contract of burin_param_info. Returns a one-line error message, or an empty string.
std::string param_problem(const burin_param_info& info);

/// Whether this is readable text: not null, not empty, UTF-8, without control characters.
bool is_text(const char* text);

}  // namespace burin
