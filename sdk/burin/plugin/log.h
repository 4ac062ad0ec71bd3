#pragma once
#include <burin/abi/ext/log.h>
#include <burin/plugin/detail/host.h>

#include <string>

namespace burin::plugin {

/// Writes lines to the host's log, or nothing if the host has no log. Any thread, concurrently.
class Log {
 public:
  explicit Log(const Host& host) : host_(host.raw()) {
    if (const auto* log = host.service<burin_log>(BURIN_EXT_LOG)) write_ = complete(*log).write;
  }

  /// Writes a line of this severity.
  /// @{
  void debug(const std::string& line) const { write(BURIN_LOG_DEBUG, line); }
  void info(const std::string& line) const { write(BURIN_LOG_INFO, line); }
  void warning(const std::string& line) const { write(BURIN_LOG_WARNING, line); }
  void error(const std::string& line) const { write(BURIN_LOG_ERROR, line); }
  /// @}

 private:
  void write(burin_log_severity severity, const std::string& line) const {
    if (write_) write_(host_, severity, line.c_str());
  }

  const burin_host* host_;
  decltype(burin_log::write) write_ = nullptr;
};

}  // namespace burin::plugin
