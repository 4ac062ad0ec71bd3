#pragma once
#include <burin/ink/decode/evdev_frames.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace burin {

/// The event of a line as `libinput record` writes it, "- [ sec, usec, type, code, value] # comment". Nothing
/// for any other line.
std::optional<EvdevEvent> libinput_event(std::string_view line);

/// A recording in which each run of such lines, with the lines "- evdev:" of the frames within, is one item,
/// "- run:" and the byte of the text at which it begins, so that a parser of YAML has next to nothing to do.
std::string with_runs_of_events(std::string_view text);

/// The number, from 0, of the line of the recording that such a line stands for.
std::size_t line_without_runs(std::string_view text, std::size_t line);

/// Calls `take` with the events of the run that such an item stands for; returns false for other texts.
bool for_each_event_of_run(std::string_view text, std::string_view item,
                           const std::function<void(const EvdevEvent& event)>& take);

}  // namespace burin
