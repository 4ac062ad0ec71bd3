#pragma once
#include <burin/base/progress.h>

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace burin {

/// A result in the order in which it was put together.
using Json = nlohmann::ordered_json;

/// The text of a result, with a line end. Bytes that are no UTF-8, as file names may have them, are replaced.
std::string json_text(const Json& json);

/// Writes a result to the standard output. Everything but the help goes this way.
void write_result(std::string_view text);

/// Whether all results could be written.
bool flush_results();

/// From here on what anybody writes to the standard output goes to stderr, but for results.
void keep_plugins_off_standard_output();

/// "burin: KIND TEXT" on stderr as one line, cut where it is very long, with control characters as \\xHH.
void say(std::string_view kind, std::string_view text);

/// "burin: warning: TEXT" on stderr.
void warn(std::string_view text);

/// What brushes have to say, as BrushLibrary takes it: "burin: LINE" on stderr, or "burin: warning: LINE".
void log_on_console(int severity, std::string_view line);

/// Draws the progress of long work into one line of the terminal behind stderr, and nothing where stderr
/// is none. The line is gone when the bar is.
class ProgressBar {
 public:
  ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ~ProgressBar();

  /// Valid as long as the bar; empty where there is nothing to draw on.
  Progress progress();

 private:
  void draw(std::string_view stage, double done);

  bool terminal_;
  std::string drawn_;
};

}  // namespace burin
