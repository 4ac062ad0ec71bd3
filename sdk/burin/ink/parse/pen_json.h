#pragma once
#include <burin/base/text/json_value.h>
#include <burin/ink/parse/text_window.h>
#include <burin/ink/pen_file.h>

#include <functional>
#include <optional>
#include <span>
#include <string_view>

namespace burin {

/// Throws FileError for JSON that is nested deeper than 200 levels or whose values would need more than 56 MB
/// once they are parsed.
void check_json_bounds(const PenFileText& file);

/// The JSON of a pen file, within these bounds. Throws FileError for more than 60 MB.
JsonValue pen_json(const PenFileText& file);

/// The JSON of a part of a pen file, within the same bounds; faults do not tell the place of the part.
JsonValue pen_json_part(const PenFileText& file, std::string_view part);

/// Whether a text begins as JSON lines: an object in the first line, and another one in the next. `whole`: an
/// object that has a member of this name is none of many.
bool begins_as_json_lines(TextWindow& text, std::span<const std::string_view> whole = {});

/// Calls `take` with the text of one value after the other, and then, if it returns false, `take_parsed` with
/// what it is. A FileError of that names the line at which the value begins.
void for_each_json_value(const PenFileText& file, const std::function<bool(std::string_view text)>& take,
                         const std::function<void(const JsonValue& value)>& take_parsed);

/// What `read` adds to a file that it reads part by part, so that one of many parts needs little memory.
/// Nothing where it returns false, leaves text behind or finds a fault: the file must then be read as a
/// whole, so that the message names the place in it. Of a file of more than 60 MB throws a FileError that
/// names the line up to which it was read.
std::optional<PenFile> pen_file_by_parts(const PenFileText& file,
                                         const std::function<bool(TextWindow& text, PenFile& content)>& read);

}  // namespace burin
