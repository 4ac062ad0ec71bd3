#pragma once
#include <string>

namespace burin::test {

/// Whether a program of other people, which tests open saved files with, is installed.
bool is_installed(const std::string& program);

/// The message of a test that is skipped because this program is missing.
std::string not_installed(const std::string& program);

}  // namespace burin::test
