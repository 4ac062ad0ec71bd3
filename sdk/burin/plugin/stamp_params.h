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

inline constexpr TextParam stamp_layer{
    .id = "layer",
    .name = "Layer",
    .help = "Of an EXR image with several, the layer to take.",
};
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

}  // namespace burin::plugin
