// Compares the hashes and counters of a result with those of a baseline, name by name.
#include "bench/baseline.h"

#include <burin/base/text/quoted_word.h>
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

namespace burin {
namespace {

using Texts = std::map<std::string, std::string>;

/// The hash and the counters as text, by name.
Texts facts(const CaseResult& result) {
  Texts facts = {{"hash", result.hash}};
  for (const auto& [name, count] : result.counters) facts[name] = std::to_string(count);
  return facts;
}

Texts facts(const JsonValue& value) {
  Texts facts = {{"hash", value.member("hash").text()}};
  for (const auto& [name, count] : value.member("counters").members())
    facts[name] = std::to_string(count.whole(0, std::numeric_limits<std::uint64_t>::max()));
  return facts;
}

void compare(const std::string& name, const Texts& was, const Texts& is, std::vector<std::string>& lines) {
  Texts all = was;
  all.insert(is.begin(), is.end());
  const auto text = [](const Texts& texts, const std::string& key) {
    const auto found = texts.find(key);
    return found == texts.end() ? "absent" : found->second;
  };
  for (const auto& [key, ignored] : all) {
    const std::string before = text(was, key), now = text(is, key);
    if (before != now) lines.push_back(fmt::format("{}: {}: was {}, is {}", name, key, before, now));
  }
}

}  // namespace

Json baseline_json(const SuiteResult& result) {
  Json cases = Json::array();
  for (const CaseResult& one : result.cases)
    cases.push_back({{"name", one.name}, {"hash", one.hash}, {"counters", one.counters}});
  return {{"burin_baseline", 1}, {"suite", result.suite}, {"cases", cases}};
}

std::vector<std::string> differences(const JsonValue& baseline, const SuiteResult& result) {
  baseline.member("burin_baseline").whole(1, 1);
  const JsonValue suite = baseline.member("suite");
  if (suite.text() != result.suite) suite.reject("is another suite than " + quoted_word(result.suite));
  std::vector<std::string> lines;
  Texts in_baseline;
  for (const JsonValue& value : baseline.member("cases").items()) {
    const std::string name = value.member("name").text();
    in_baseline[name];
    const auto found = std::find_if(result.cases.begin(), result.cases.end(),
                                    [&](const CaseResult& one) { return one.name == name; });
    if (found == result.cases.end())
      lines.push_back(name + ": was measured, is absent");
    else
      compare(name, facts(value), facts(*found), lines);
  }
  for (const CaseResult& one : result.cases)
    if (!in_baseline.contains(one.name)) lines.push_back(one.name + ": was absent, is measured");
  return lines;
}

}  // namespace burin
