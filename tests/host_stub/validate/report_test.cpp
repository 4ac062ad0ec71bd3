#include "validate/report.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "../run_command.h"

namespace burin::test {
namespace {

TEST(ValidateReport, ShowsTheFirstFailuresOnly) {
  using namespace validate;
  const std::vector<Result> results(5, {find_check("shape.seam"), Verdict::fail, "a step"});
  Subject subject;
  subject.module = "a.burin";
  const std::string text = short_report(subject, results);
  EXPECT_EQ(std::ranges::count(text, '\n'), 3 * 3 + 2) << text;
  EXPECT_NE(text.find("and 2 more failures: burin validate a.burin\n"), std::string::npos) << text;
}

TEST(ValidateReport, NamesTheClauseThatACallBreaksWhichDoesNotReturn) {
  using namespace validate;
  const std::vector<Result> results = {{find_check("shape.seam"), Verdict::timeout, "did not end"},
                                       {find_check("shape.seam"), Verdict::fail, "a step"}};
  Subject subject;
  subject.module = bad_plugin("good");
  const std::string late = "base.h: every call returns", step = find_check("shape.seam")->clause;
  const Json json = json_report(subject, results, 4);
  EXPECT_EQ(json["checks"][0]["clause"], late);
  EXPECT_EQ(json["checks"][1]["clause"], step);
  for (const std::string& text : {text_report(subject, results), junit_report(subject, results)}) {
    EXPECT_LT(text.find(late), text.find(step)) << text;
    EXPECT_NE(text.find(step), std::string::npos) << text;
  }
}

TEST(ValidateReport, TellsOfMemoryBeforeWhatComesOfIt) {
  using namespace validate;
  const std::vector<Result> results = {{find_check("life.two-brushes"), Verdict::crash, {}},
                                       {find_check("memory.writes-within"), Verdict::crash, {}}};
  Subject subject;
  subject.module = "a.burin";
  const std::string text = short_report(subject, results);
  EXPECT_TRUE(text.starts_with("CRASH   memory.writes-within\n")) << text;
  EXPECT_NE(text.find("CRASH   life.two-brushes\n"), std::string::npos) << text;
}

}  // namespace
}  // namespace burin::test
