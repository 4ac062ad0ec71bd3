#pragma once
#include <burin/ink/decode/evdev_frames.h>
#include <burin/ink/parse/text_window.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace burin {

/// The event of a line as `libinput record` writes it, "- [ sec, usec, type, code, value] # comment". Nothing
/// for any other line.
std::optional<EvdevEvent> libinput_event(std::string_view line);

/// Goes through the lines of a recording as a parser of YAML is to see them: each run of such lines, with the
/// lines "- evdev:" of the frames within, is one item, "- run:ABOVE:FIRST", the bytes of the text at which
/// the line above it and the run begin. So the parser has next to nothing to do.
class LibinputLines {
 public:
  /// The file must outlive the object.
  explicit LibinputLines(const PenFileText& file) : text_(file) {}

  /// Sets the next line, without its newline. Returns false at the end.
  bool next(std::string& line);

  std::size_t number() const { return number_; }  ///< of the recording's line that it stands for, from 1

 private:
  TextWindow text_;
  std::string above_;
  std::uintmax_t above_at_ = 0;
  bool in_run_ = false;
  std::size_t number_ = 0;
};

/// Calls `take` with the events of the run that such an item stands for; returns false for other texts, and
/// for runs that begin before the window, which is of the recording and then at the end of the run.
bool for_each_event_of_run(TextWindow& text, std::string_view item,
                           const std::function<void(const EvdevEvent& event)>& take);

}  // namespace burin
