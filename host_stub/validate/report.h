#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "system/console.h"
#include "validate/run_checks.h"

namespace burin::validate {

/// How many checks came out in each way; crashes and time limits count as failed.
struct Counts {
  int passed = 0, failed = 0, skipped = 0;
};
Counts count(std::span<const Result> results);

/// The highest level of which, and of all below which, no check failed; 0 if one of level 1 did. At most
/// `highest`, the level up to which checks were run.
int level_reached(std::span<const Result> results, int highest);

/// A word as a shell takes it.
std::string shell_word(const std::string& word);

/// A command that runs one check again.
std::string command_of(const Subject& subject, const Check& check);

/// Lines for people, the last of them "N passed, N failed, N skipped"; short: the first three failures only,
/// since one mistake makes many checks fail.
std::string text_report(const Subject& subject, std::span<const Result> results);
std::string short_report(const Subject& subject, std::span<const Result> results);
Json json_report(const Subject& subject, std::span<const Result> results, int highest);
std::string junit_report(const Subject& subject, std::span<const Result> results);

}  // namespace burin::validate
