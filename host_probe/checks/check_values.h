#pragma once
#include <burin/abi/brush.h>

#include "../strokes.h"

namespace burin_probe {

/// Whether this is UTF-8 text, which may be empty.
bool is_utf8(const char* text);

/// Checks a buffer for the text of an error; null means that the host wants none.
void check_text(const burin_text* text);

/// Checks values of parameters of a brush of this module, of `nodes` elements.
void check_params(const burin_params* params, std::uint32_t nodes);

/// Checks that numbers have stride 0, as outside of evaluate.
void check_single(const burin_params* params);

/// Keeps the numbers of a stroke, and checks that those that may not vary are the same later.
void keep_numbers(Stroke& stroke, const burin_params& params);
void check_constant(const Stroke& stroke, const burin_params& params, std::uint32_t nodes);

}  // namespace burin_probe
