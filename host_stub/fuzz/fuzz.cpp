// Runs random trials in processes of their own, and shrinks the first that fails.
#include "fuzz/fuzz.h"

#include <burin/base/error.h>
#include <burin/base/stopwatch.h>
#include <burin/host/brush_library.h>
#include <burin/level_set/solid_mesh.h>
#include <burin/services/stamp_services.h>
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <sstream>
#include <string_view>

#include "fuzz/bundle.h"
#include "fuzz/fuzz_case.h"
#include "fuzz/shrink.h"
#include "input/brush_folder.h"
#include "system/child_tasks.h"
#include "validate/probe/plugin.h"
#include "validate/probe/stroke.h"

namespace burin {
namespace fs = std::filesystem;

namespace {

using End = ChildResult::End;

/// Trials for shrinking.
constexpr int tries = 400;
/// While a trial that hangs is shrunk, every step that hangs takes as long as it may: so many times what the
/// longest trial took that did not hang, seconds; and there may be so many such steps.
constexpr double longer_than_others = 10, least_limit = 0.5;
constexpr int steps_that_hang = 60;

FuzzCase case_of(const validate::Subject& subject, const TakenWords& words, std::size_t number) {
  const validate::Plugin plugin(subject);
  const auto brushes = plugin.brushes();
  if (brushes.empty()) throw Error("the module has no brushes");
  return random_case(*brushes[number % brushes.size()], words, subject.seed ^ (number * 0x9E3779B97F4A7C15u));
}

/// Tries which words a brush begins with for its parameter `param`, and adds a line "BRUSH PARAMETER TYPE
/// NUMBER" for each of these. A file that is taken stays.
void try_words(validate::ProbeBrush& probe, std::uint32_t param, const fs::path& folder, std::string& lines) {
  const burin_param_info& info = *probe.descriptor.params[param];
  const bool file = info.type == BURIN_PARAM_FILE;
  const std::vector<std::string> words = fuzz_words(info.type);
  const std::string before = probe.values.text(param);
  std::string kept = before;
  for (std::size_t number = 0; number < words.size(); ++number) {
    const std::string word = file ? (folder / words[number]).string() : words[number];
    probe.values.set_text(param, word);
    if (!probe.begins()) continue;
    lines += fmt::format("{} {} {} {}\n", probe.descriptor.id, info.id, info.type, number);
    if (file && kept == before) kept = word;
  }
  probe.values.set_text(param, kept);
}

/// Of all brushes. Texts come behind files, since many are refused with the wrong file only.
std::string lines_of_taken_words(const validate::Subject& subject) {
  std::string lines;
  const validate::Plugin plugin(subject);
  for (const burin_brush_descriptor* brush : plugin.brushes()) {
    validate::ProbeBrush probe(plugin, *brush, subject);
    for (const burin_param_type type : {BURIN_PARAM_FILE, BURIN_PARAM_TEXT})
      for (std::uint32_t i = 0; i < brush->param_count; ++i)
        if (brush->params[i]->type == type) try_words(probe, i, subject.folder, lines);
  }
  return lines;
}

/// In a process of its own, which a brush may end: then any word is tried.
TakenWords taken_words(const validate::Subject& subject, double time_limit) {
  TakenWords words;
  const ChildResult child =
      run_in_children(1, 1, time_limit, [&](std::size_t) { return lines_of_taken_words(subject); })[0];
  if (child.end != End::whole) return words;
  std::istringstream lines(child.text);
  burin_param_type type = 0;
  std::size_t number = 0;
  for (std::string brush, param; lines >> brush >> param >> type >> number;)
    words[{brush, param}].push_back(fuzz_words(type).at(number));
  return words;
}

/// What a child sends: a digit, the outcome, and its text. An error is a module that cannot be loaded.
constexpr char unloadable = '9';

std::string sent(const validate::Subject& subject, const std::function<const Trial&()>& trial) {
  try {
    const TrialResult result = run_trial(subject.module, subject.folder, trial());
    return std::to_string(static_cast<int>(result.outcome)) + result.text;
  } catch (const std::exception& error) {
    return unloadable + std::string(error.what());
  }
}

bool failed(const ChildResult& child) {
  return child.end != End::whole || child.text[0] == '0' + static_cast<int>(Outcome::broke);
}

std::string failure_text(const ChildResult& child) {
  return child.end == End::whole ? child.text.substr(1) : child.text;
}

/// A failure without its numbers, by which failures of one kind are known.
std::string kind_of(const ChildResult& child) {
  std::string kind = failure_text(child);
  std::erase_if(kind, [](char c) {
    return (c >= '0' && c <= '9') || std::string_view("+-.e").find(c) != std::string_view::npos;
  });
  return kind;
}

class Fuzzer {
 public:
  Fuzzer(const validate::Subject& subject, const FuzzOptions& options)
      : subject_(subject), options_(options) {}

  FuzzResult run() {
    expect_module_that_loads();
    words_ = taken_words(subject_, options_.time_limit);
    const Stopwatch watch;
    do run_some();
    while (result_.failure.empty() && watch.elapsed() < 60 * options_.minutes);
    return result_;
  }

 private:
  /// In a process of its own, since this one loads the module too when a trial has failed.
  void expect_module_that_loads() const {
    const ChildResult loaded = run_in_children(1, 1, options_.time_limit, [&](std::size_t) {
      try {
        BrushLibrary library(nullptr, stamp_services(read_vdb));
        load_module(library, subject_.module);
        return std::string();
      } catch (const std::exception& error) {
        return std::string(error.what());
      }
    })[0];
    if (!loaded.text.empty()) throw Error(loaded.text);
  }

  void run_some() {
    const std::size_t first = result_.trials, count = 4 * static_cast<std::size_t>(options_.jobs);
    const auto children = run_in_children(count, options_.jobs, options_.time_limit, [&](std::size_t index) {
      FuzzCase made;
      return sent(subject_, [&]() -> const Trial& {
        made = case_of(subject_, words_, first + index);
        return made.trial;
      });
    });
    for (const ChildResult& child : children) {
      if (child.end == End::whole && child.text[0] == unloadable) throw Error(child.text.substr(1));
      if (failed(child)) return report(child);
      longest_ = std::max(longest_, child.seconds);
      ++result_.trials;
      if (child.text[0] != '0' + static_cast<int>(Outcome::refused)) continue;
      ++result_.refused;
      result_.refusal = child.text.substr(1);
    }
  }

  ChildResult run_alone(const Trial& trial, double limit) {
    return run_in_children(
        1, 1, limit, [&](std::size_t) { return sent(subject_, [&]() -> const Trial& { return trial; }); })[0];
  }

  /// The least case that fails as the child did, and with what.
  FuzzCase least_of(const FuzzCase& failing, const ChildResult& child, std::string& failure) {
    if (child.end == End::late) return least_that_hangs(failing);
    const auto fails = [&](const FuzzCase& some) {
      const ChildResult again = run_alone(some.trial, options_.time_limit);
      if (!failed(again) || again.end != child.end || kind_of(again) != kind_of(child)) return false;
      failure = failure_text(again);
      return true;
    };
    return shrunk(failing, fails, tries);
  }

  /// What takes longer than others need not hang, so the result is tried with the whole time. If it ends by
  /// then, the case is shrunk again with four times the limit.
  FuzzCase least_that_hangs(const FuzzCase& failing) {
    const auto hangs_for = [&](const FuzzCase& some, double limit) {
      return run_alone(some.trial, limit).end == End::late;
    };
    for (double limit = std::max(longer_than_others * longest_, least_limit); limit < options_.time_limit;
         limit *= 4) {
      int left = steps_that_hang;
      FuzzCase least = shrunk(
          failing, [&](const FuzzCase& some) { return left > 0 && hangs_for(some, limit) && left-- > 0; },
          tries);
      if (hangs_for(least, options_.time_limit)) return least;
    }
    return failing;
  }

  /// Of the trial that was the next one.
  void report(const ChildResult& child) {
    const std::size_t number = result_.trials++;
    std::string failure = failure_text(child);
    const FuzzCase least = least_of(case_of(subject_, words_, number), child, failure);
    write_bundle(options_.bundle, {subject_.module, failure, least.trial, options_.time_limit},
                 subject_.folder);
    result_.failure = fmt::format("trial {}: {}\n        {} samples, {} vertices, {}", number, failure,
                                  least.trial.stroke.samples.size(), least.trial.mesh.positions.size(),
                                  least.trial.settings.dump());
  }

  const validate::Subject& subject_;
  const FuzzOptions& options_;
  TakenWords words_;
  FuzzResult result_;
  double longest_ = 0;  ///< of the trials that did not fail, seconds
};

}  // namespace

FuzzResult fuzz(const validate::Subject& subject, const FuzzOptions& options) {
  return Fuzzer(subject, options).run();
}

}  // namespace burin
