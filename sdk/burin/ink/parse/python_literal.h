#pragma once
#include <string>
#include <string_view>

namespace burin {

/// A Python literal of lists, tuples, dictionaries, numbers, texts and names as JSON: tuples become lists,
/// True, False and None what JSON calls them, and commas before a closing bracket go. Lines stay where they
/// are. What is no such literal becomes text that is no JSON.
std::string json_of_python(std::string_view literal);

}  // namespace burin
