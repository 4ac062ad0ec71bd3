// Runs each case in a process of its own, `burin bench SUITE --case NAME --json`, and reads the result from
// the standard output of that process.
#include "bench/run_suite.h"

#include <burin/base/error.h>
#include <burin/base/program_file.h>
#include <burin/base/text/quoted_word.h>
#include <fmt/format.h>

#include <cstdio>
#include <string_view>

#include "bench/regression.h"
#include "system/child_process.h"

namespace burin {
namespace {

/// The last line that a command wrote to stderr, without the leading program name.
std::string complaint(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  std::string line = text.substr(text.rfind('\n') + 1);
  constexpr std::string_view name = "burin: ";
  if (line.rfind(name, 0) == 0) line.erase(0, name.size());
  return line;
}

[[noreturn]] void fail(const ProgramResult& result, const std::filesystem::path& burin,
                       const std::string& case_name) {
  std::string what = complaint(result.err);
  if (what.empty())
    what = fmt::format("{}: case {} ended with {}", burin.string(), quoted_word(case_name), result.exit_code);
  if (result.exit_code == 2) throw Error(what);
  throw Regression(what);
}

}  // namespace

CaseResult run_case_in_process(const std::filesystem::path& burin, const Suite& suite,
                               const std::string& case_name, std::optional<std::size_t> repeat,
                               const std::filesystem::path& picture) {
  std::vector<std::string> command = {burin.string(), "bench", suite.path, "--case", case_name, "--json"};
  if (repeat) command.insert(command.end(), {"--repeat", std::to_string(*repeat)});
  if (!picture.empty()) command.insert(command.end(), {"--picture", picture.string()});
  const ProgramResult result = run_program(command);
  if (result.exit_code != 0) fail(result, burin, case_name);
  std::fputs(result.err.c_str(), stderr);
  const JsonValue file = JsonValue::parse(result.out, burin.string());
  SuiteResult read = read_result(file);
  if (read.cases.size() != 1 || read.cases[0].name != case_name)
    file.reject(fmt::format("did not run case {}", quoted_word(case_name)));
  read.cases[0].picture = picture;
  return std::move(read.cases[0]);
}

std::filesystem::path picture_file(const std::filesystem::path& folder, std::size_t number) {
  return folder.empty() ? folder : folder / fmt::format("{}.png", number);
}

SuiteResult run_suite(const Suite& suite, std::optional<std::size_t> repeat,
                      const std::filesystem::path& pictures, const Progress& progress) {
  SuiteResult result{suite.name, {}};
  for (const BenchCase& one : suite.cases) {
    report(progress, one.name,
           static_cast<double>(result.cases.size()) / static_cast<double>(suite.cases.size()));
    const std::filesystem::path picture = picture_file(pictures, result.cases.size() + 1);
    result.cases.push_back(run_case_in_process(program_file(), suite, one.name, repeat, picture));
  }
  return result;
}

}  // namespace burin
