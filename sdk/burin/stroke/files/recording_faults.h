#pragma once
#include <burin/stroke/recording.h>

#include <string_view>

namespace burin {

/// The reason why a value is not allowed in a `.stroke` file, or an empty text if it is allowed. Reader and
/// writer use these functions.
std::string_view validation_error(const Camera& camera);
std::string_view validation_error(const Dynamic& dynamic);
std::string_view validation_error(const Sample& sample);

}  // namespace burin
