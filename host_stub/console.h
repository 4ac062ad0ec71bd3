#pragma once
#include <burin/base/progress.h>

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace burin {

/// A result in the order in which it was put together.
using Json = nlohmann::ordered_json;

/// The text of a result. Bytes that are no UTF-8, as file names may have them, are replaced.
std::string json_text(const Json& json);

/// "burin: warning: TEXT" on stderr.
void warn(std::string_view text);

/// What brushes have to say, as BrushLibrary takes it: "burin: LINE" on stderr.
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
