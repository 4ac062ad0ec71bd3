/* The layout of every struct of the ABI on machines with 8-byte pointers, written out once: layout.c and
 * layout_test.cpp both hold the headers against it. A line that has to change here is a break of the ABI;
 * a struct that grows gets a new line and a new size.
 *
 *   STRUCT(type, bytes)
 *   MEMBER(type, member, byte offset)
 */
#ifndef BURIN_TESTS_ABI_LAYOUT_H
#define BURIN_TESTS_ABI_LAYOUT_H

#include <burin/abi/ext/bench_budget.h>
#include <burin/abi/ext/curve_filter.h>
#include <burin/abi/ext/lettering.h>
#include <burin/abi/ext/log.h>
#include <burin/abi/ext/stamps.h>
#include <burin/abi/ext/state.h>
#include <burin/abi/ext/vdb_stamps.h>
#include <burin/abi/ext/volume.h>
#include <burin/abi/plugin.h>

/* clang-format off */
#define BURIN_ABI_LAYOUT(STRUCT, MEMBER) \
  STRUCT(burin_text, 16) \
  MEMBER(burin_text, struct_size, 0) \
  MEMBER(burin_text, capacity, 4) \
  MEMBER(burin_text, data, 8) \
  STRUCT(burin_floats, 16) \
  MEMBER(burin_floats, data, 0) \
  MEMBER(burin_floats, stride, 8) \
  MEMBER(burin_floats, reserved, 12) \
  STRUCT(burin_indices, 16) \
  MEMBER(burin_indices, data, 0) \
  MEMBER(burin_indices, stride, 8) \
  MEMBER(burin_indices, reserved, 12) \
  STRUCT(burin_floats_out, 16) \
  MEMBER(burin_floats_out, data, 0) \
  MEMBER(burin_floats_out, stride, 8) \
  MEMBER(burin_floats_out, reserved, 12) \
  STRUCT(burin_vectors, 48) \
  MEMBER(burin_vectors, x, 0) \
  MEMBER(burin_vectors, y, 16) \
  MEMBER(burin_vectors, z, 32) \
  STRUCT(burin_colours, 64) \
  MEMBER(burin_colours, r, 0) \
  MEMBER(burin_colours, g, 16) \
  MEMBER(burin_colours, b, 32) \
  MEMBER(burin_colours, a, 48) \
  STRUCT(burin_host, 48) \
  MEMBER(burin_host, struct_size, 0) \
  MEMBER(burin_host, abi_major, 4) \
  MEMBER(burin_host, abi_minor, 8) \
  MEMBER(burin_host, reserved, 12) \
  MEMBER(burin_host, self, 16) \
  MEMBER(burin_host, name, 24) \
  MEMBER(burin_host, version, 32) \
  MEMBER(burin_host, get_extension, 40) \
  STRUCT(burin_param_info, 112) \
  MEMBER(burin_param_info, struct_size, 0) \
  MEMBER(burin_param_info, type, 4) \
  MEMBER(burin_param_info, id, 8) \
  MEMBER(burin_param_info, name, 16) \
  MEMBER(burin_param_info, help, 24) \
  MEMBER(burin_param_info, unit, 32) \
  MEMBER(burin_param_info, hard_min, 36) \
  MEMBER(burin_param_info, hard_max, 40) \
  MEMBER(burin_param_info, soft_min, 44) \
  MEMBER(burin_param_info, soft_max, 48) \
  MEMBER(burin_param_info, default_number, 52) \
  MEMBER(burin_param_info, default_colour, 56) \
  MEMBER(burin_param_info, default_file, 72) \
  MEMBER(burin_param_info, choices, 80) \
  MEMBER(burin_param_info, default_knots, 88) \
  MEMBER(burin_param_info, default_knot_count, 96) \
  MEMBER(burin_param_info, dynamic, 100) \
  MEMBER(burin_param_info, default_text, 104) \
  STRUCT(burin_param_value, 104) \
  MEMBER(burin_param_value, number, 0) \
  MEMBER(burin_param_value, colour, 16) \
  MEMBER(burin_param_value, text, 80) \
  MEMBER(burin_param_value, knots, 88) \
  MEMBER(burin_param_value, knot_count, 96) \
  MEMBER(burin_param_value, reserved, 100) \
  STRUCT(burin_params, 16) \
  MEMBER(burin_params, struct_size, 0) \
  MEMBER(burin_params, count, 4) \
  MEMBER(burin_params, values, 8) \
  STRUCT(burin_stroke_context, 72) \
  MEMBER(burin_stroke_context, struct_size, 0) \
  MEMBER(burin_stroke_context, pass, 4) \
  MEMBER(burin_stroke_context, flags, 8) \
  MEMBER(burin_stroke_context, pen_present, 16) \
  MEMBER(burin_stroke_context, seed, 24) \
  MEMBER(burin_stroke_context, length, 32) \
  MEMBER(burin_stroke_context, radius_min, 40) \
  MEMBER(burin_stroke_context, radius_max, 48) \
  MEMBER(burin_stroke_context, object_scale, 56) \
  MEMBER(burin_stroke_context, dab_t, 64) \
  STRUCT(burin_batch, 832) \
  MEMBER(burin_batch, struct_size, 0) \
  MEMBER(burin_batch, count, 4) \
  MEMBER(burin_batch, params, 8) \
  MEMBER(burin_batch, t, 16) \
  MEMBER(burin_batch, d, 32) \
  MEMBER(burin_batch, radius, 48) \
  MEMBER(burin_batch, stretch, 64) \
  MEMBER(burin_batch, footprint_t, 80) \
  MEMBER(burin_batch, footprint_d, 96) \
  MEMBER(burin_batch, position, 112) \
  MEMBER(burin_batch, normal, 160) \
  MEMBER(burin_batch, e1, 208) \
  MEMBER(burin_batch, mean_curvature, 256) \
  MEMBER(burin_batch, laplacian, 272) \
  MEMBER(burin_batch, displacement, 320) \
  MEMBER(burin_batch, mask, 368) \
  MEMBER(burin_batch, colour, 384) \
  MEMBER(burin_batch, sheet, 448) \
  MEMBER(burin_batch, visit_count, 464) \
  MEMBER(burin_batch, node_id, 480) \
  MEMBER(burin_batch, symmetry, 496) \
  MEMBER(burin_batch, pressure, 512) \
  MEMBER(burin_batch, tilt_x, 528) \
  MEMBER(burin_batch, tilt_y, 544) \
  MEMBER(burin_batch, twist, 560) \
  MEMBER(burin_batch, speed, 576) \
  MEMBER(burin_batch, time, 592) \
  MEMBER(burin_batch, foot, 608) \
  MEMBER(burin_batch, foot_normal, 656) \
  MEMBER(burin_batch, fine_position, 704) \
  MEMBER(burin_batch, fine_normal, 752) \
  MEMBER(burin_batch, fine_mean_curvature, 800) \
  MEMBER(burin_batch, end_distance, 816) \
  STRUCT(burin_outputs, 136) \
  MEMBER(burin_outputs, struct_size, 0) \
  MEMBER(burin_outputs, count, 4) \
  MEMBER(burin_outputs, along, 8) \
  MEMBER(burin_outputs, across, 24) \
  MEMBER(burin_outputs, up, 40) \
  MEMBER(burin_outputs, mask, 56) \
  MEMBER(burin_outputs, colour, 72) \
  STRUCT(burin_brush_descriptor, 96) \
  MEMBER(burin_brush_descriptor, struct_size, 0) \
  MEMBER(burin_brush_descriptor, param_count, 4) \
  MEMBER(burin_brush_descriptor, id, 8) \
  MEMBER(burin_brush_descriptor, name, 16) \
  MEMBER(burin_brush_descriptor, vendor, 24) \
  MEMBER(burin_brush_descriptor, version, 32) \
  MEMBER(burin_brush_descriptor, help, 40) \
  MEMBER(burin_brush_descriptor, features, 48) \
  MEMBER(burin_brush_descriptor, params, 56) \
  MEMBER(burin_brush_descriptor, inputs_read, 64) \
  MEMBER(burin_brush_descriptor, outputs_written, 72) \
  MEMBER(burin_brush_descriptor, overlap, 80) \
  MEMBER(burin_brush_descriptor, reserved, 84) \
  MEMBER(burin_brush_descriptor, rim_slope, 88) \
  MEMBER(burin_brush_descriptor, reserved2, 92) \
  STRUCT(burin_stroke_plan, 16) \
  MEMBER(burin_stroke_plan, struct_size, 0) \
  MEMBER(burin_stroke_plan, passes, 4) \
  MEMBER(burin_stroke_plan, end_influence, 8) \
  STRUCT(burin_brush, 56) \
  MEMBER(burin_brush, struct_size, 0) \
  MEMBER(burin_brush, reserved, 4) \
  MEMBER(burin_brush, self, 8) \
  MEMBER(burin_brush, destroy, 16) \
  MEMBER(burin_brush, get_extension, 24) \
  MEMBER(burin_brush, begin, 32) \
  MEMBER(burin_brush, evaluate, 40) \
  MEMBER(burin_brush, end, 48) \
  STRUCT(burin_brush_factory, 24) \
  MEMBER(burin_brush_factory, struct_size, 0) \
  MEMBER(burin_brush_factory, brush_count, 4) \
  MEMBER(burin_brush_factory, brushes, 8) \
  MEMBER(burin_brush_factory, create, 16) \
  STRUCT(burin_plugin_entry, 40) \
  MEMBER(burin_plugin_entry, struct_size, 0) \
  MEMBER(burin_plugin_entry, abi_major, 4) \
  MEMBER(burin_plugin_entry, abi_minor, 8) \
  MEMBER(burin_plugin_entry, reserved, 12) \
  MEMBER(burin_plugin_entry, init, 16) \
  MEMBER(burin_plugin_entry, deinit, 24) \
  MEMBER(burin_plugin_entry, get_factory, 32) \
  STRUCT(burin_log, 16) \
  MEMBER(burin_log, struct_size, 0) \
  MEMBER(burin_log, reserved, 4) \
  MEMBER(burin_log, write, 8) \
  STRUCT(burin_stamp, 8) \
  MEMBER(burin_stamp, handle, 0) \
  STRUCT(burin_stamp_options, 40) \
  MEMBER(burin_stamp_options, struct_size, 0) \
  MEMBER(burin_stamp_options, wrap_u, 4) \
  MEMBER(burin_stamp_options, wrap_v, 8) \
  MEMBER(burin_stamp_options, clean, 12) \
  MEMBER(burin_stamp_options, layer, 16) \
  MEMBER(burin_stamp_options, channel, 24) \
  MEMBER(burin_stamp_options, zero, 32) \
  MEMBER(burin_stamp_options, reserved, 36) \
  STRUCT(burin_stamp_area, 64) \
  MEMBER(burin_stamp_area, along_u, 0) \
  MEMBER(burin_stamp_area, along_v, 16) \
  MEMBER(burin_stamp_area, across_u, 32) \
  MEMBER(burin_stamp_area, across_v, 48) \
  STRUCT(burin_stamp_info, 32) \
  MEMBER(burin_stamp_info, struct_size, 0) \
  MEMBER(burin_stamp_info, width, 4) \
  MEMBER(burin_stamp_info, height, 8) \
  MEMBER(burin_stamp_info, channels, 12) \
  MEMBER(burin_stamp_info, minimum, 16) \
  MEMBER(burin_stamp_info, maximum, 20) \
  MEMBER(burin_stamp_info, wrap_u, 24) \
  MEMBER(burin_stamp_info, wrap_v, 28) \
  STRUCT(burin_stamps, 48) \
  MEMBER(burin_stamps, struct_size, 0) \
  MEMBER(burin_stamps, reserved, 4) \
  MEMBER(burin_stamps, open, 8) \
  MEMBER(burin_stamps, close, 16) \
  MEMBER(burin_stamps, sample, 24) \
  MEMBER(burin_stamps, open_with, 32) \
  MEMBER(burin_stamps, sample_area, 40) \
  STRUCT(burin_lettering_info, 32) \
  MEMBER(burin_lettering_info, struct_size, 0) \
  MEMBER(burin_lettering_info, width, 4) \
  MEMBER(burin_lettering_info, ascent, 8) \
  MEMBER(burin_lettering_info, descent, 12) \
  MEMBER(burin_lettering_info, left, 16) \
  MEMBER(burin_lettering_info, right, 20) \
  MEMBER(burin_lettering_info, bottom, 24) \
  MEMBER(burin_lettering_info, top, 28) \
  STRUCT(burin_lettering, 16) \
  MEMBER(burin_lettering, struct_size, 0) \
  MEMBER(burin_lettering, reserved, 4) \
  MEMBER(burin_lettering, set, 8) \
  STRUCT(burin_state, 24) \
  MEMBER(burin_state, struct_size, 0) \
  MEMBER(burin_state, version, 4) \
  MEMBER(burin_state, save, 8) \
  MEMBER(burin_state, load, 16) \
  STRUCT(burin_solid_plan, 32) \
  MEMBER(burin_solid_plan, struct_size, 0) \
  MEMBER(burin_solid_plan, operation, 4) \
  MEMBER(burin_solid_plan, h_min, 8) \
  MEMBER(burin_solid_plan, h_max, 16) \
  MEMBER(burin_solid_plan, detail, 24) \
  STRUCT(burin_volume, 24) \
  MEMBER(burin_volume, struct_size, 0) \
  MEMBER(burin_volume, reserved, 4) \
  MEMBER(burin_volume, plan, 8) \
  MEMBER(burin_volume, distance, 16) \
  STRUCT(burin_curve_reach, 24) \
  MEMBER(burin_curve_reach, struct_size, 0) \
  MEMBER(burin_curve_reach, reserved, 4) \
  MEMBER(burin_curve_reach, behind, 8) \
  MEMBER(burin_curve_reach, ahead, 16) \
  STRUCT(burin_curve_points, 168) \
  MEMBER(burin_curve_points, struct_size, 0) \
  MEMBER(burin_curve_points, count, 4) \
  MEMBER(burin_curve_points, t, 8) \
  MEMBER(burin_curve_points, position, 24) \
  MEMBER(burin_curve_points, normal, 72) \
  MEMBER(burin_curve_points, e1, 120) \
  STRUCT(burin_curve_filter, 24) \
  MEMBER(burin_curve_filter, struct_size, 0) \
  MEMBER(burin_curve_filter, reserved, 4) \
  MEMBER(burin_curve_filter, reach, 8) \
  MEMBER(burin_curve_filter, filter, 16) \
  STRUCT(burin_vdb_stamp, 8) \
  MEMBER(burin_vdb_stamp, handle, 0) \
  STRUCT(burin_vdb_options, 24) \
  MEMBER(burin_vdb_options, struct_size, 0) \
  MEMBER(burin_vdb_options, periodic, 4) \
  MEMBER(burin_vdb_options, grid, 8) \
  MEMBER(burin_vdb_options, surface_at, 16) \
  STRUCT(burin_vdb_info, 32) \
  MEMBER(burin_vdb_info, struct_size, 0) \
  MEMBER(burin_vdb_info, kind, 4) \
  MEMBER(burin_vdb_info, size, 8) \
  MEMBER(burin_vdb_info, minimum, 20) \
  MEMBER(burin_vdb_info, maximum, 24) \
  MEMBER(burin_vdb_info, reserved, 28) \
  STRUCT(burin_vdb_stamps, 32) \
  MEMBER(burin_vdb_stamps, struct_size, 0) \
  MEMBER(burin_vdb_stamps, reserved, 4) \
  MEMBER(burin_vdb_stamps, open, 8) \
  MEMBER(burin_vdb_stamps, close, 16) \
  MEMBER(burin_vdb_stamps, sample, 24) \
  STRUCT(burin_bench_budget, 16) \
  MEMBER(burin_bench_budget, struct_size, 0) \
  MEMBER(burin_bench_budget, reserved, 4) \
  MEMBER(burin_bench_budget, evaluate_cost, 8)
/* clang-format on */

/* A line of the layout as a compiler sees it. */
typedef struct layout_line {
  const char* type;
  const char* member; /* "" for the struct itself */
  size_t bytes;       /* size of the struct, or offset of the member */
} layout_line;

#ifdef __cplusplus
extern "C" {
#endif
/* The layout as the C compiler sees it; `count` lines. */
const layout_line* burin_layout_in_c(size_t* count);
#ifdef __cplusplus
}
#endif
#endif
