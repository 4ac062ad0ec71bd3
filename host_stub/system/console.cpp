// Writes results to the original standard output, and messages, progress and whatever plugins print to
// stderr.
#include "system/console.h"

#include <burin/abi/ext/log.h>
#include <burin/base/text/quoted_word.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "system/platform.h"

namespace burin {

std::string json_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

namespace {

/// The original standard output, after plugins were given another one; null before.
std::FILE* results = nullptr;

}  // namespace

void say(std::string_view kind, std::string_view text) {
  constexpr std::size_t most = 8000;
  const std::string line = printable(text.substr(0, most));
  std::fputs(fmt::format("burin: {}{}{}\n", kind, line, text.size() > most ? "..." : "").c_str(), stderr);
}

void keep_plugins_off_standard_output() {
  if (!results) results = divert_standard_output();
}

void write_result(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), results ? results : stdout);
}

bool flush_results() {
  std::FILE* const out = results ? results : stdout;
  return std::fflush(out) == 0 && std::ferror(out) == 0;
}

void warn(std::string_view text) { say("warning: ", text); }

void log_on_console(int severity, std::string_view line) {
  if (severity == BURIN_LOG_WARNING) return warn(line);
  say(severity == BURIN_LOG_DEBUG ? "debug: " : "", line);
}

ProgressBar::ProgressBar() : terminal_(stderr_is_terminal()) {}

ProgressBar::~ProgressBar() {
  if (!drawn_.empty()) std::fputs("\r\033[K", stderr);
}

Progress ProgressBar::progress() {
  if (!terminal_) return {};
  return [this](std::string_view stage, double done) { draw(stage, done); };
}

void ProgressBar::draw(std::string_view stage, double done) {
  constexpr int width = 32;
  const int filled = std::clamp(static_cast<int>(done * width), 0, width);
  std::string line = fmt::format("\r\033[K{:<20} [{:#<{}}{:<{}}] {:3.0f} %", stage, "", filled, "",
                                 width - filled, std::clamp(done, 0.0, 1.0) * 100);
  if (line == drawn_) return;
  std::fputs(line.c_str(), stderr);
  drawn_ = std::move(line);
}

}  // namespace burin
