#pragma once
#include <burin/ink/pen_file.h>

namespace burin {

// The kinds of pen file: whether a text begins like one, and its reader. docs/recordings.md has their units,
// time bases and ranges.

bool is_inkml(std::string_view text);
PenFile read_inkml(const PenFileText& file);

bool is_xournal(std::string_view text);
PenFile read_xournal(const PenFileText& file);

bool is_svg(std::string_view text);
PenFile read_svg(const PenFileText& file);

bool is_evemu(std::string_view text);
PenFile read_evemu(const PenFileText& file);

bool is_hid(std::string_view text);
PenFile read_hid(const PenFileText& file);

bool is_libinput(std::string_view text);
PenFile read_libinput(const PenFileText& file);

bool is_pointers(std::string_view text);
PenFile read_pointers(const PenFileText& file);

bool is_brush_strokes(std::string_view text);
PenFile read_brush_strokes(const PenFileText& file);

bool is_csv(std::string_view text);
PenFile read_csv(const PenFileText& file);

}  // namespace burin
