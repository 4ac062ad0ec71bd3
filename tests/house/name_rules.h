#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace burin::test {

/// Names that several sources of one room keep to themselves, in namespaces without a name, each as
/// "ROOM: NAME: FILE, FILE". Sources of a room are compiled together, so these must be unique. Functions of
/// one name may have other parameters, and an alias may stand for the same type everywhere.
std::vector<std::string> repeated_names(const std::filesystem::path& repository);

}  // namespace burin::test
