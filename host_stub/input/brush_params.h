#pragma once
#include <burin/abi/plugin.h>
#include <burin/host/brush_library.h>

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace burin {

/// Whether the brush, or without `brush` any brush, has a parameter with this name and one of these types.
bool has_param(const BrushLibrary& brushes, const std::optional<std::string>& brush, std::string_view name,
               std::initializer_list<burin_param_type> types);

}  // namespace burin
