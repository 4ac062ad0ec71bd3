#pragma once
#include <burin/plugin/batch.h>
#include <burin/plugin/common_params.h>
#include <burin/plugin/falloff.h>
#include <burin/plugin/outputs.h>
#include <burin/plugin/params.h>
#include <burin/plugin/shapes.h>

#include <algorithm>
#include <cstddef>

/// Draws figures on the surface: raises, colours and masks it. A brush that uses Ink declares ink::inputs,
/// ink::outputs and, in its param_list, the four parameters below.
namespace burin::plugin::ink {

/// What a brush with Ink declares.
inline constexpr std::uint64_t inputs =
    BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS | BURIN_INPUT_FOOTPRINT;
inline constexpr std::uint64_t outputs = BURIN_OUTPUT_DISPLACEMENT | BURIN_OUTPUT_MASK | BURIN_OUTPUT_COLOUR;

/// What a brush with Ink lists among its parameters.
/// @{
inline constexpr FloatParam height =
    common::height("How far the figure stands out; below 0 it is engraved.", {-0.5f, 0.5f}, 0.1f);
inline constexpr FloatParam bevel{
    .id = "bevel",
    .name = "Bevel",
    .help = "Width of the slope inside of the figure's outline; never steeper than the mesh can show.",
    .unit = BURIN_UNIT_RADIUS,
    .hard = {0, 10},
    .soft = {0, 0.5f},
    .default_value = 0.06f,
};
inline constexpr ColourParam colour{
    .id = "colour",
    .name = "Colour",
    .help = "Ink; its alpha says how much it covers, 0 leaves the colours alone.",
    .default_value = {0, 0, 0, 0},
};
inline constexpr FloatParam mask{
    .id = "mask",
    .name = "Mask",
    .help = "How much the figure is protected from later strokes.",
    .hard = {0, 1},
    .default_value = 0,
};
/// @}

/// Writes the outputs of a batch, one element per call.
class Ink {
 public:
  Ink(const Batch& in, const Outputs& out)
      : radius_(in.radius()),
        height_(in.params[height]),
        bevel_(in.params[bevel].value()),
        protects_(in.params[mask].value()),
        ink_(in.params[colour]),
        up_(out.up()),
        mask_(out.mask()),
        colour_(out.colour()) {}

  /// The width of the slope at an element, object units.
  float slope(std::size_t i, float footprint) const { return std::max(bevel_ * radius_[i], footprint); }

  /// Draws a figure whose outline is `distance` away (negative inside) into a cell of this size; object
  /// units.
  void draw(std::size_t i, float distance, float footprint) const {
    const float rise = smooth_step(-distance / std::max(slope(i, footprint), 1e-30f));
    draw_covered(i, coverage(distance, footprint), rise);
  }

  /// Draws a figure that covers this share of the cell (0..1) and has `rise` (0..1) of its height there.
  void draw_covered(std::size_t i, float covered, float rise) const {
    up_[i] = height_[i] * radius_[i] * rise;
    mask_[i] *= 1 - protects_ * covered;
    colour_.composite_over(i, ink_, covered);
  }

 private:
  const Floats radius_, height_;
  const float bevel_, protects_;
  const Colours ink_;
  const FloatsOut up_, mask_;
  const ColoursOut colour_;
};

}  // namespace burin::plugin::ink
