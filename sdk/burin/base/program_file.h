#pragma once
#include <filesystem>

namespace burin {

/// The file of the running program. Throws std::filesystem::filesystem_error if the system does not tell.
std::filesystem::path program_file();

/// The path of a file or folder that comes with a program of Burin, or with the shared library that this code
/// is in: beside that, as in a build tree, if it is there, else in lib/burin beside its folder, where it is
/// installed.
std::filesystem::path beside_own_file(const char* name);

}  // namespace burin
