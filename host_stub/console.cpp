#include "console.h"

#include <burin/abi/ext/log.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "platform.h"

namespace burin {

std::string json_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

namespace {

/// Where results go once plugins have the standard output to themselves.
std::FILE* results = nullptr;

}  // namespace

void keep_plugins_off_standard_output() {
  if (!results) results = divert_standard_output();
}

void write_result(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), results ? results : stdout);
}

bool flush_results() { return std::fflush(results ? results : stdout) == 0; }

void warn(std::string_view text) { std::fputs(fmt::format("burin: warning: {}\n", text).c_str(), stderr); }

void log_on_console(int severity, std::string_view line) {
  if (severity == BURIN_LOG_WARNING) return warn(line);
  std::fputs(fmt::format("burin: {}\n", line).c_str(), stderr);
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
