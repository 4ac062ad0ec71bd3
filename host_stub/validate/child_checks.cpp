// Runs checks in forked processes, so that a plugin that crashes or hangs fails one check only. A child
// sends its verdict through a pipe and is killed at its time limit.
#include "validate/child_checks.h"

#include <burin/base/text/quoted_word.h>
#include <burin/host/brush_library.h>
#include <burin/host/plugin/brush_params.h>
#include <fmt/format.h>

#include <filesystem>

#include "input/brush_folder.h"
#include "system/child_tasks.h"
#include "validate/probe/values.h"

namespace burin::validate {
namespace {

/// In the child: a digit, the verdict, and the text.
std::string run_alone(Subject subject, const Check& check) {
  subject.folder /= check.name;
  std::filesystem::create_directories(subject.folder);
  const Result result = run_here(subject, check);
  return std::to_string(static_cast<int>(result.verdict)) + result.text;
}

Result result_of(const Check& check, const ChildResult& child) {
  switch (child.end) {
    case ChildResult::End::late:
      return {&check, Verdict::timeout, child.text, child.seconds};
    case ChildResult::End::crashed:
      return {&check, Verdict::crash, child.text, child.seconds};
    default:
      return {&check, static_cast<Verdict>(child.text[0] - '0'), child.text.substr(1), child.seconds};
  }
}

/// What is wrong with values for a module that can be loaded, or nothing.
std::string params_problem(const Subject& subject) {
  BrushLibrary library;
  try {
    load_module(library, subject.module);
  } catch (const Error&) {
    return {};  // The checks tell it.
  }
  for (const BrushEntry& brush : library.brushes()) const Values values(*brush.descriptor, subject);
  for (const auto& [name, value] : subject.params)
    if (!has_param(library, nullptr, name, {}))
      return fmt::format("no brush of {} has a parameter {}", subject.module.string(), quoted_word(name));
  return {};
}

}  // namespace

void check_params(const Subject& subject) {
  if (subject.params.empty()) return;
  const ChildResult child = run_in_children(1, 1, time_limit, [&](std::size_t) {
    try {
      return params_problem(subject);
    } catch (const std::exception& error) {
      return std::string(error.what());
    }
  })[0];
  if (child.end == ChildResult::End::whole && !child.text.empty()) throw Error(child.text);
}

std::vector<Result> run_checks_in_children(const Subject& subject, std::span<const Check* const> checks,
                                           int jobs) {
  const auto children = run_in_children(
      checks.size(), jobs, time_limit, [&](std::size_t index) { return run_alone(subject, *checks[index]); });
  std::vector<Result> results;
  for (const ChildResult& child : children) results.push_back(result_of(*checks[results.size()], child));
  return results;
}

}  // namespace burin::validate
