#pragma once
#include <burin/stroke/recording.h>

#include <string_view>

namespace burin {

/// What keeps a value out of a `.stroke` file, for reader and writer alike; empty when nothing does.
std::string_view fault_of(const Camera& camera);
std::string_view fault_of(const Dynamic& dynamic);
std::string_view fault_of(const RecordedStroke& settings);
std::string_view fault_of(const Sample& sample);

}  // namespace burin
