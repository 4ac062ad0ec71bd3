#pragma once
#include <burin/abi/brush.h>

#include <string>

namespace burin {

/// 2^24, to which floats hold every whole number: INT parameters stay within.
inline constexpr float largest_whole_param = 16777216;

/// What breaks the contract of burin_brush_descriptor, in a line; empty when all is in order.
std::string descriptor_problem(const burin_brush_descriptor& descriptor);

/// The same for one parameter.
std::string param_problem(const burin_param_info& info);

/// Whether this is text for people: not null or empty, UTF-8, without control characters.
bool is_text(const char* text);

}  // namespace burin
