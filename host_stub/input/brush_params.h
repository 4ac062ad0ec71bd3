#pragma once
#include <burin/abi/plugin.h>
#include <burin/host/brush_library.h>

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace burin {

/// Whether this brush has a parameter of this name and of one of these types; unless a brush is named,
/// whether any has.
bool has_param(const BrushLibrary& brushes, const std::optional<std::string>& brush, std::string_view name,
               std::initializer_list<burin_param_type> types);

}  // namespace burin
