// Writes the results of checks as JSON, as JUnit's XML and as lines for people.
#include "validate/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "report/html_text.h"
#include "validate/badge.h"

namespace burin::validate {
namespace {

/// Text as XML has it, without control characters, which it cannot hold.
std::string xml(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < 0x20; }, ' ');
  return escaped(text);
}

}  // namespace

std::string shell_word(const std::string& word) {
  if (word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./+") ==
      word.npos)
    return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

Counts count(std::span<const Result> results) {
  Counts counts;
  for (const Result& result : results)
    ++(has_failed(result) ? counts.failed : result.verdict == Verdict::pass ? counts.passed : counts.skipped);
  return counts;
}

int level_reached(std::span<const Result> results, int highest) {
  int level = highest;
  for (const Result& result : results)
    if (has_failed(result)) level = std::min(level, result.check->level - 1);
  return level;
}

std::string command_of(const Subject& subject, const Check& check) {
  std::string command = fmt::format("burin validate {} --only {} --seed {}",
                                    shell_word(subject.module.string()), check.name, subject.seed);
  for (const auto& [name, value] : subject.params)
    command += fmt::format(" --param {}", shell_word(fmt::format("{}={}", name, value)));
  return command;
}

namespace {

/// The clause that a result is about: that of its check, unless a call did not return.
std::string_view clause_of(const Result& result) {
  return result.verdict == Verdict::timeout ? "base.h: every call returns" : result.check->clause;
}

std::string text_of(const Subject& subject, const Result& result) {
  std::string text = fmt::format("{:<7} {}{}{}\n", name_of(result.verdict), result.check->name,
                                 result.text.empty() ? "" : ": ", result.text);
  if (!has_failed(result)) return text;
  return text +
         fmt::format("        {}\n        {}\n", clause_of(result), command_of(subject, *result.check));
}

std::string text_of(const Counts& counts) {
  return fmt::format("{} passed, {} failed, {} skipped\n", counts.passed, counts.failed, counts.skipped);
}

}  // namespace

std::string text_report(const Subject& subject, std::span<const Result> results) {
  std::string text;
  for (const Result& result : results) text += text_of(subject, result);
  return text + text_of(count(results));
}

std::string short_report(const Subject& subject, std::span<const Result> results) {
  constexpr std::size_t most = 3;
  std::vector<Result> failures;
  std::ranges::copy_if(results, std::back_inserter(failures), has_failed);
  // A write beyond an array makes other checks crash, which tells less.
  std::stable_partition(failures.begin(), failures.end(), [](const Result& result) {
    return std::string_view(result.check->name).starts_with("memory.");
  });
  std::string text;
  for (const Result& result : std::span(failures).first(std::min(most, failures.size())))
    text += text_of(subject, result);
  if (failures.size() > most)
    text += fmt::format("and {} more failures: burin validate {}\n", failures.size() - most,
                        shell_word(subject.module.string()));
  return text + text_of(count(results));
}

Json json_report(const Subject& subject, std::span<const Result> results, int highest) {
  Json checks = Json::array();
  for (const Result& result : results)
    checks.push_back({{"name", result.check->name},
                      {"level", result.check->level},
                      {"verdict", name_of(result.verdict)},
                      {"text", result.text},
                      {"clause", clause_of(result)},
                      {"seconds", result.seconds},
                      {"command", command_of(subject, *result.check)}});
  const Counts counts = count(results);
  return {{"module", subject.module.string()},
          {"hash", module_hash(subject.module)},
          {"seed", subject.seed},
          {"level", level_reached(results, highest)},
          {"passed", counts.passed},
          {"failed", counts.failed},
          {"skipped", counts.skipped},
          {"checks", checks}};
}

std::string junit_report(const Subject& subject, std::span<const Result> results) {
  const Counts counts = count(results);
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" "
      "skipped=\"{}\">\n",
      xml(subject.module.filename().string()), results.size(), counts.failed, counts.skipped);
  for (const Result& result : results) {
    text += fmt::format("  <testcase classname=\"burin.validate\" name=\"{}\" time=\"{:.3f}\">",
                        result.check->name, result.seconds);
    if (has_failed(result))
      text += fmt::format("<failure message=\"{}: {}\">{}\n{}</failure>", name_of(result.verdict),
                          xml(result.text), xml(std::string(clause_of(result))),
                          xml(command_of(subject, *result.check)));
    else if (result.verdict == Verdict::skip)
      text += fmt::format("<skipped message=\"{}\"/>", xml(result.text));
    text += "</testcase>\n";
  }
  return text + "</testsuite>\n";
}

}  // namespace burin::validate
