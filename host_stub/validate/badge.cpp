// Writes and reads the badge beside a plugin. The hash of the module's file in it tells whether it is
// still about this module.
#include "validate/badge.h"

#include <burin/abi/base.h>
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/base/hash.h>
#include <burin/version.h>
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "system/console.h"

namespace burin::validate {

std::string module_hash(const std::filesystem::path& module) {
  const std::string bytes = read_file(module);
  return hash_text(hash_bytes(bytes.data(), bytes.size()));
}

std::string badge_text(const std::filesystem::path& module, int level) {
  return json_text({{"level", level},
                    {"hash", module_hash(module)},
                    {"burin", BURIN_VERSION},
                    {"abi", fmt::format("{}.{}", BURIN_ABI_MAJOR, BURIN_ABI_MINOR)}});
}

std::filesystem::path badge_file(const std::filesystem::path& module) {
  return std::filesystem::path(module).replace_extension(".badge.json");
}

std::optional<int> badge_level(const std::filesystem::path& module) {
  if (!std::filesystem::exists(badge_file(module))) return std::nullopt;
  const Json badge = Json::parse(read_file(badge_file(module)), nullptr, false);
  if (!badge.is_object() || badge.value("hash", Json()) != Json(module_hash(module))) return std::nullopt;
  const Json level = badge.value("level", Json());
  return level.is_number_integer() ? std::optional(level.get<int>()) : std::nullopt;
}

}  // namespace burin::validate
