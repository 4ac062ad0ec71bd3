#pragma once
#include <optional>
#include <string_view>

namespace burin {

/// Seconds since 1970 of a time as ISO 8601 writes it, "2024-01-31T10:20:30.5+01:00", with a blank instead of
/// the T too; without seconds or zone these are 0. Nothing for any other text.
std::optional<double> iso_time(std::string_view text);

}  // namespace burin
