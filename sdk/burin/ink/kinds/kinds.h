#pragma once
#include <burin/ink/pen_file.h>

#include <string_view>

namespace burin {

/// Of CSS, 96 to the inch; what programs without a device's resolution mean by pixels.
inline constexpr double millimetres_a_pixel = 25.4 / 96;

// The kinds of pen file: whether a text begins like one, and its reader. docs/recordings.md has their units,
// time bases and ranges.

bool is_uim(std::string_view text);
PenFile read_uim(const PenFileText& file);

bool is_uim_json(std::string_view text);
PenFile read_uim_json(const PenFileText& file);

bool is_will(std::string_view text);
PenFile read_will(const PenFileText& file);

bool is_tilt(std::string_view text);
PenFile read_tilt(const PenFileText& file);

bool is_isf(std::string_view text);
PenFile read_isf(const PenFileText& file);

bool is_remarkable(std::string_view text);
PenFile read_remarkable(const PenFileText& file);

bool is_excalidraw(std::string_view text);
PenFile read_excalidraw(const PenFileText& file);

bool is_point_lists(std::string_view text);
PenFile read_point_lists(const PenFileText& file);

bool is_scap(std::string_view text);
PenFile read_scap(const PenFileText& file);

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

bool is_mypaint(std::string_view text);
PenFile read_mypaint(const PenFileText& file);

bool is_svc(std::string_view text);
PenFile read_svc(const PenFileText& file);

bool is_pointer_arrays(std::string_view text);
PenFile read_pointer_arrays(const PenFileText& file);

bool is_csv(std::string_view text);
PenFile read_csv(const PenFileText& file);

}  // namespace burin
