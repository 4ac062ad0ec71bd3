// Keeps the first calls of a host, and counts all. Arrays of fixed size, for evaluate must not allocate.
#include "calls.h"

#include <algorithm>
#include <atomic>
#include <cinttypes>

#include "rules.h"

namespace burin_probe {
namespace {

constexpr const char* call_names[] = {"init",         "deinit",        "get_factory",    "create",
                                      "destroy",      "get_extension", "begin",          "evaluate",
                                      "end",          "solid plan",    "solid distance", "curve reach",
                                      "curve filter", "state save",    "state load"};
constexpr std::size_t call_kinds = std::size(call_names);

/// A call that was noted; `whole` is set last.
struct Noted {
  Call call = Call::init;
  unsigned thread = 0;
  std::uint64_t about = 0, nodes = 0;
  std::atomic<bool> whole{false};
};

/// All calls of one kind.
struct Total {
  std::atomic<std::uint64_t> calls{0}, nodes{0}, least{UINT64_MAX}, most{0};
};

constexpr std::size_t longest_log = 4096;
Noted log_of_calls[longest_log];
std::atomic<std::size_t> logged{0};
Total totals[call_kinds];
std::atomic<int> most_running{0};

template <class Number>
void raise_to(std::atomic<Number>& most, Number value) {
  Number before = most;
  while (before < value && !most.compare_exchange_weak(before, value)) {
  }
}

void lower_to(std::atomic<std::uint64_t>& least, std::uint64_t value) {
  std::uint64_t before = least;
  while (before > value && !least.compare_exchange_weak(before, value)) {
  }
}

/// Calls of the same kind about the same stroke, one after the other.
struct Run {
  const Noted* first = nullptr;
  std::uint64_t calls = 0, nodes = 0;
  unsigned least_thread = UINT32_MAX, greatest_thread = 0;
};

void write_run(std::FILE* file, const Run& run) {
  std::fprintf(file, run.least_thread == run.greatest_thread ? "  thread %u" : "  threads %u to %u",
               run.least_thread, run.greatest_thread);
  std::fprintf(file, ": %s", call_names[static_cast<std::size_t>(run.first->call)]);
  if (run.first->about > 0) std::fprintf(file, " %" PRIu64, run.first->about);
  if (run.calls > 1) std::fprintf(file, ", %" PRIu64 " times", run.calls);
  if (run.nodes > 0) std::fprintf(file, ", %" PRIu64 " nodes", run.nodes);
  std::fprintf(file, "\n");
}

/// The run of calls that begins at `first`; returns where the next begins.
std::size_t take_run(std::size_t first, std::size_t count, Run& run) {
  std::size_t i = first;
  run.first = &log_of_calls[first];
  for (; i < count; ++i) {
    const Noted& noted = log_of_calls[i];
    if (!noted.whole || noted.call != run.first->call || noted.about != run.first->about) break;
    ++run.calls;
    run.nodes += noted.nodes;
    run.least_thread = std::min(run.least_thread, noted.thread);
    run.greatest_thread = std::max(run.greatest_thread, noted.thread);
  }
  return std::max(i, first + 1);
}

}  // namespace

void note_call(Call call, std::uint64_t about, std::uint64_t nodes) {
  Total& total = totals[static_cast<std::size_t>(call)];
  ++total.calls;
  total.nodes += nodes;
  lower_to(total.least, nodes);
  raise_to(total.most, nodes);
  const std::size_t place = logged++;
  if (place >= longest_log) return;
  Noted& noted = log_of_calls[place];
  noted.call = call;
  noted.thread = thread_number();
  noted.about = about;
  noted.nodes = nodes;
  noted.whole = true;
}

void note_running(int calls) { raise_to(most_running, calls); }

void write_calls(std::FILE* file) {
  std::fprintf(file, "calls on %u threads, at most %d of evaluate at once\n", thread_count(),
               most_running.load());
  for (std::size_t kind = 0; kind < call_kinds; ++kind) {
    const Total& total = totals[kind];
    if (total.calls == 0) continue;
    std::fprintf(file, "  %-14s %" PRIu64, call_names[kind], total.calls.load());
    if (total.nodes > 0)
      std::fprintf(file, ", %" PRIu64 " nodes, %" PRIu64 " to %" PRIu64 " at a time", total.nodes.load(),
                   total.least.load(), total.most.load());
    std::fprintf(file, "\n");
  }
  const std::size_t count = std::min<std::size_t>(logged, longest_log);
  std::fprintf(file, "\nthe first %zu calls in their order, with the number of their brush or stroke\n",
               count);
  for (std::size_t i = 0; i < count;) {
    Run run{};
    i = take_run(i, count, run);
    if (run.calls > 0) write_run(file, run);
  }
}

}  // namespace burin_probe
