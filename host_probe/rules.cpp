// Counts how often each rule was kept and broken. Only atomic numbers are written, so that brushes may
// note rules during evaluate on all threads.
#include "rules.h"

namespace burin_probe {
namespace {

constexpr RuleText texts[] = {
#define BURIN_PROBE_TEXT(name, id, clause) {id, clause},
    BURIN_PROBE_RULES(BURIN_PROBE_TEXT)
#undef BURIN_PROBE_TEXT
};
Seen seen[rule_count];
std::atomic<unsigned> threads{0};

}  // namespace

const RuleText* rule_texts() { return texts; }
Seen* rules_seen() { return seen; }

bool expect(Rule rule, bool kept, const char* what, double value) {
  Seen& one = seen[static_cast<std::size_t>(rule)];
  if (kept) {
    one.kept.fetch_add(1, std::memory_order_relaxed);
  } else if (one.broken.fetch_add(1, std::memory_order_relaxed) == 0) {
    one.first_what = what;
    one.first_value = value;
    one.first_thread = thread_number();
  }
  return kept;
}

unsigned thread_number() {
  static thread_local const unsigned number = ++threads;
  return number;
}

unsigned thread_count() { return threads; }

}  // namespace burin_probe
