// Writes the probe's report as lines for people: calls, then the rules that were broken, kept or never
// seen.
#include "report.h"

#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "calls.h"
#include "rules.h"
#include "strokes.h"

namespace burin_probe {
namespace {

void write_broken(std::FILE* file, const RuleText& text, const Seen& seen) {
  std::fprintf(file,
               "BROKEN  %s, %" PRIu64 " times of %" PRIu64 ", first on thread %u: %s = %.9g\n        %s\n",
               text.id, seen.broken.load(), seen.broken + seen.kept, seen.first_thread, seen.first_what,
               seen.first_value, text.clause);
}

void write_rules(std::FILE* file) {
  std::size_t kept = 0, broken = 0;
  for (std::size_t i = 0; i < rule_count; ++i) {
    const Seen& seen = rules_seen()[i];
    if (seen.broken > 0) {
      ++broken;
      write_broken(file, rule_texts()[i], seen);
    } else if (seen.kept > 0) {
      ++kept;
      std::fprintf(file, "kept    %s\n", rule_texts()[i].id);
    } else {
      std::fprintf(file, "unseen  %s\n", rule_texts()[i].id);
    }
  }
  std::fprintf(file, "\n%zu rules kept, %zu broken, %zu unseen\n", kept, broken, rule_count - kept - broken);
}

}  // namespace

void write_report() {
  const char* path = std::getenv("BURIN_PROBE_REPORT");
  std::FILE* file = path && *path ? std::fopen(path, "w") : nullptr;
  if (!file) return;
  write_calls(file);
  const EndedStrokes strokes = ended_strokes();
  std::fprintf(file,
               "\nstrokes drawn: %" PRIu64 ", of which %" PRIu64
               " ended without BURIN_STROKE_FINAL, as only dropped ones may\n\n",
               strokes.all, strokes.unfinished);
  write_rules(file);
  std::fclose(file);
}

}  // namespace burin_probe
