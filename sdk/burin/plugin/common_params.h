#pragma once
#include <burin/plugin/detail/param_values.h>
#include <burin/plugin/params.h>
#include <burin/plugin/stamps.h>

namespace burin::plugin {

/// Parameters of brushes with stamps: whether to fill texels that are not finite, and which channels of the
/// file to use.
inline constexpr BoolParam clean_stamp{
    .id = "clean",
    .name = "Clean",
    .help = "Fills texels that are not finite from their neighbours; else such a file is refused.",
};

/// The layer of an image that has several.
inline constexpr TextParam stamp_layer{
    .id = "layer",
    .name = "Layer",
    .help = "Of an EXR image with several, the layer to take.",
};
/// The channels of the image to use.
inline constexpr TextParam stamp_channel{
    .id = "channel",
    .name = "Channel",
    .help = "The channel of the image to take, or three between commas; else its names tell.",
};

/// The options of a brush with the values of these parameters set. Valid as long as `params`.
inline StampOptions chosen(StampOptions options, const Params& params) {
  options.clean = params[clean_stamp].value();
  options.layer = params[stamp_layer];
  options.channel = params[stamp_channel];
  return options;
}

/// Parameters that many brushes have, so that they are called and measured alike:
///   static constexpr FloatParam width = common::width("Distance from the middle to the rim.", 0.8f);
/// `soft` is what a slider spans.
namespace common {

/// How far the surface is moved, radii.
constexpr FloatParam depth(const char* help, Range soft, float default_value) {
  return {.id = "depth",
          .name = "Depth",
          .help = help,
          .unit = BURIN_UNIT_RADIUS,
          .hard = {-10, 10},
          .soft = soft,
          .default_value = default_value,
          .dynamic = true};
}

/// The same of what stands out, radii.
constexpr FloatParam height(const char* help, Range soft, float default_value) {
  FloatParam height = depth(help, soft, default_value);
  height.id = "height";
  height.name = "Height";
  return height;
}

/// The height of a shape that is round across the stroke, a multiple of half the shape's own width.
constexpr FloatParam roundness(const char* help, float default_value) {
  FloatParam roundness = height(help, {0, 2}, default_value);
  roundness.unit = BURIN_UNIT_NONE;
  return roundness;
}

/// Half the extent across the stroke, radii.
constexpr FloatParam width(const char* help, float default_value, float least = 0.01f) {
  return {.id = "width",
          .name = "Width",
          .help = help,
          .unit = BURIN_UNIT_RADIUS,
          .hard = {least, 1},
          .default_value = default_value,
          .dynamic = true};
}

/// The same of patterns that one width holds for from end to end: it does not vary along the stroke.
constexpr FloatParam whole_width(const char* help, float default_value, float least = 0.01f) {
  FloatParam whole = width(help, default_value, least);
  whole.dynamic = false;
  return whole;
}

/// Length over which the brush fades out at either end of the stroke, radii; as taper_factor() takes it.
constexpr FloatParam taper(const char* help, float default_value) {
  return {.id = "taper",
          .name = "Taper",
          .help = help,
          .unit = BURIN_UNIT_RADIUS,
          .hard = {0, 1000},
          .soft = {0, 10},
          .default_value = default_value};
}

/// Length of a tile along the stroke, radii.
constexpr FloatParam tile(Range soft, float default_value) {
  return {.id = "tile",
          .name = "Tile",
          .help = "Length of a tile along the stroke.",
          .unit = BURIN_UNIT_RADIUS,
          .hard = {0.01f, 1000},
          .soft = soft,
          .default_value = default_value};
}

/// Share of the radius over which the brush fades out at the rim.
constexpr FloatParam fade(const char* help, float default_value, float least = 0.01f) {
  return {.id = "fade", .name = "Fade", .help = help, .hard = {least, 1}, .default_value = default_value};
}

/// How much of its whole effect the brush has.
constexpr FloatParam amount(const char* help, Range hard, float default_value, Range soft = {}) {
  return {.id = "amount",
          .name = "Amount",
          .help = help,
          .hard = hard,
          .soft = soft,
          .default_value = default_value,
          .dynamic = true};
}

/// The same parameter where the brush takes one value for the whole stroke.
constexpr FloatParam constant(FloatParam param) {
  param.dynamic = false;
  return param;
}

}  // namespace common
}  // namespace burin::plugin
