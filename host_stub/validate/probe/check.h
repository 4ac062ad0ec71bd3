#pragma once
#include <burin/base/error.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>

namespace burin::validate {

/// What a check is given.
struct Subject {
  std::filesystem::path module;                    ///< absolute
  std::filesystem::path folder;                    ///< a folder for files of this check, which exists
  std::filesystem::path stamp;                     ///< an image for parameters that must name a file
  std::filesystem::path solid;                     ///< an OpenVDB file for those that do not take an image
  std::uint64_t seed = 1;                          ///< of all that is random
  std::map<std::string, std::string> params = {};  ///< values instead of defaults, as users type them
};

/// The plugin broke the clause of the check. what() says how, in one line.
class Failed : public Error {
 public:
  using Error::Error;
};

/// There is nothing to check. what() says why, in one line.
class Skipped : public Error {
 public:
  using Error::Error;
};

/// The check passed and found something to tell. what() is that, in one line.
class Told : public Error {
 public:
  using Error::Error;
};

/// Throws Failed with this text unless `holds`.
inline void require(bool holds, const std::string& otherwise) {
  if (!holds) throw Failed(otherwise);
}

/// Runs `check`; what it tells where it fails begins with `where`.
template <class Function>
void tell_where(const std::string& where, const Function& check) {
  try {
    check();
  } catch (const Failed& failed) {
    throw Failed(where + failed.what());
  }
}

/// A rule of the plugin ABI and how it is tested.
struct Check {
  const char* name;    ///< "TOPIC.RULE"
  int level;           ///< 1 loads and behaves, 2 the contract, 3 robust, 4 deterministic and bounded, 5 fast
  const char* clause;  ///< "HEADER: what it says"
  const char* what;    ///< what the check does, one sentence
  void (*run)(const Subject& subject);  ///< throws Failed, Skipped or Told
};

inline constexpr int levels = 5;

/// All checks, in the order in which they are run.
std::span<const Check> all_checks();

/// The check with this name, or null.
const Check* find_check(std::string_view name);

// The checks of each topic.
std::span<const Check> module_checks();
std::span<const Check> descriptor_checks();
std::span<const Check> struct_checks();
std::span<const Check> value_checks();
std::span<const Check> life_checks();
std::span<const Check> host_checks();
std::span<const Check> evaluate_checks();
std::span<const Check> memory_checks();
std::span<const Check> shape_checks();
std::span<const Check> process_checks();
std::span<const Check> repeat_checks();
std::span<const Check> ability_checks();
std::span<const Check> speed_checks();

}  // namespace burin::validate
