#pragma once
#include <functional>
#include <string_view>

namespace burin {

/// Calls `take` with the name and the text of each member of the object that a text of JSON is, or with an
/// empty name and the text of each item of the array, so that each can be parsed by itself. Follows brackets
/// and quotes only. Returns false if the text is neither, if something else stands between or behind the
/// parts, for more than 500,000 of them, or once `take` does.
bool for_each_json_part(std::string_view json,
                        const std::function<bool(std::string_view name, std::string_view part)>& take);

}  // namespace burin
