#pragma once
#include <filesystem>
#include <optional>
#include <string>

namespace burin::validate {

/// The bits of a module's file as 16 hexadecimal digits.
std::string module_hash(const std::filesystem::path& module);

/// Text of a badge: the level that a module reached, its hash, the versions of Burin and of the ABI.
std::string badge_text(const std::filesystem::path& module, int level);

/// Where `burin list` looks for the badge of a module: beside it, NAME.badge.json.
std::filesystem::path badge_file(const std::filesystem::path& module);

/// The level that the badge beside a module states, or nothing if there is none or the module is another one.
std::optional<int> badge_level(const std::filesystem::path& module);

}  // namespace burin::validate
