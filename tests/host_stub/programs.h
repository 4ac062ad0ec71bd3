#pragma once
#include <string>

namespace burin::test {

/// Whether a program of other people, which tests open saved files with, is installed.
bool is_installed(const std::string& program);

/// What a test that needs one says when it is skipped.
std::string not_installed(const std::string& program);

}  // namespace burin::test
