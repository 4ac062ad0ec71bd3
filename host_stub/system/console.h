#pragma once
#include <burin/base/progress.h>

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace burin {

/// JSON with members in insertion order.
using Json = nlohmann::ordered_json;

/// The text of a JSON value, with a line end. Bytes that are not UTF-8, as in some file names, are replaced.
std::string json_text(const Json& json);

/// Writes a result to the standard output. All output except the help uses this function.
void write_result(std::string_view text);

/// Flushes the results; returns whether all could be written.
bool flush_results();

/// Redirects everything that is written to the standard output from now on to stderr, except results.
void keep_plugins_off_standard_output();

/// Writes "burin: KIND TEXT" to stderr as one line. Control characters are escaped as \\xHH, and a very long
/// line is cut.
void say(std::string_view kind, std::string_view text);

/// Writes "burin: warning: TEXT" to stderr.
void warn(std::string_view text);

/// A BrushLibrary::Log that writes "burin: LINE" to stderr; "burin: warning: LINE" and "burin: debug: LINE"
/// at these severities.
void log_on_console(int severity, std::string_view line);

/// Shows the progress of long work in one line of the terminal, if stderr is a terminal. The destructor
/// erases the line.
class ProgressBar {
 public:
  ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ~ProgressBar();

  /// The function to report progress to; valid as long as the bar, empty if stderr is not a terminal.
  Progress progress();

 private:
  void draw(std::string_view stage, double done);

  bool terminal_;
  std::string drawn_;
};

}  // namespace burin
