#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace burin::test {

/// Includes between the rooms of a folder of the house that go against the rules, each as "FILE:LINE: WHAT".
/// What a header at the folder's top includes counts for the rooms that include that header.
std::vector<std::string> wrong_room_includes(const std::filesystem::path& repository);

/// Rooms that may include themselves by way of others: the rules should have none.
std::vector<std::string> rooms_in_circles();

/// Folders below sdk, brushes, host_stub and tests with more than 20 sources, each as "FOLDER: COUNT". Files
/// that differ in their extension, or in "_test" at the end, count as one.
std::vector<std::string> crowded_folders(const std::filesystem::path& repository);

/// Tests of a file of sdk/burin or host_stub that are not in the folder of `tests` that is named like its
/// own.
std::vector<std::string> misplaced_tests(const std::filesystem::path& repository);

}  // namespace burin::test
