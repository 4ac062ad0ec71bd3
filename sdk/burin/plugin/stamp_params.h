#pragma once
#include <burin/plugin/param_values.h>
#include <burin/plugin/params.h>
#include <burin/plugin/stamps.h>

namespace burin::plugin {

/// A parameter for brushes with stamps: what to do with a file whose texels are not all finite.
inline constexpr BoolParam clean_stamp{
    .id = "clean",
    .name = "Clean",
    .help = "Fills texels that are not finite from their neighbours; else such a file is refused.",
};

/// The options as a brush has them, and what that parameter says.
inline StampOptions cleaned(StampOptions options, const Params& params) {
  options.clean = params[clean_stamp].value();
  return options;
}

}  // namespace burin::plugin
