#pragma once
#include <burin/abi/plugin.h>
#include <burin/host/brush_library.h>

#include <initializer_list>
#include <string>
#include <string_view>

namespace burin {

/// Whether the brush, or any brush if `brush` is null, has a parameter with this name and one of
/// these types, or any type if there are none.
bool has_param(const BrushLibrary& brushes, const std::string* brush, std::string_view name,
               std::initializer_list<burin_param_type> types);

/// Whether the value of a parameter is a text whatever it looks like: a text, a file or a choice.
bool takes_text(burin_param_type type);

/// Whether that is so of this parameter.
bool takes_text(const BrushLibrary& brushes, const std::string* brush, std::string_view name);

}  // namespace burin
