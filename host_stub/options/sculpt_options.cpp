#include "options/sculpt_options.h"

#include <burin/base/quoted_word.h>
#include <CLI/CLI.hpp>
#include <optional>

#include "options/options.h"
#include "options/stroke_choices.h"

namespace burin {
namespace {

void set_mirrors(Symmetry& symmetry, const std::string& axes) {
  if (axes.empty()) throw CLI::ValidationError("--mirror", "takes x, y, z or several of them");
  for (const char axis : axes) {
    if (axis != 'x' && axis != 'y' && axis != 'z')
      throw CLI::ValidationError("--mirror", "takes x, y, z or several of them, not " + quoted_word(axes));
    (axis == 'x' ? symmetry.mirror_x : axis == 'y' ? symmetry.mirror_y : symmetry.mirror_z) = true;
  }
}

void add_symmetry_options(CLI::App& command, Symmetry& symmetry) {
  command
      .add_option_function<std::string>(
          "--mirror", [&symmetry](const std::string& axes) { set_mirrors(symmetry, axes); },
          "draw each stroke mirrored along these axes too: x, y, z, xy ...")
      ->type_name("AXES");
  auto* radial =
      command.add_option("--radial", symmetry.radial, "draw each stroke so many times around an axis")
          ->check(CLI::Range(1, 128))
          ->capture_default_str();
  command
      .add_option_function<std::string>(
          "--radial-axis", [&symmetry](const std::string& axis) { symmetry.axis = axis[0] - 'x'; },
          "that axis: x, y (the default) or z")
      ->check(CLI::IsMember({"x", "y", "z"}))
      ->needs(radial);
  add_point_option(command, "--symmetry-centre", symmetry.centre,
                   "where mirror planes and axis meet; the origin unless given");
}

}  // namespace

void add_sculpt_options(CLI::App& command, StrokeOverrides& overrides) {
  command
      .add_option_function<std::string>(
          "--overlap",
          [&overrides](const std::string& name) { overrides.overlap = overlap_names().at(name); },
          "where a stroke overlaps itself: strongest, latest, max, min, add or average; as its brush says\n"
          "unless given")
      ->check(CLI::IsMember({"strongest", "latest", "max", "min", "add", "average"}));
  command
      .add_option_function<std::string>(
          "--accumulate",
          [&overrides](const std::string& name) {
            overrides.accumulate = name == "current" ? Accumulate::from_current : Accumulate::from_base;
          },
          "what a stroke starts from where it comes to a place again: base (the default), the surface "
          "before\n"
          "the stroke, or current, what it has made of it")
      ->check(CLI::IsMember({"base", "current"}));
  command.add_flag("--clamp", overrides.clamp_to_radius, "let no vertex go farther than one radius");
  add_symmetry_options(command, overrides.symmetry);
  command
      .add_option("--dabs", overrides.dab_spacing,
                  "draw a row of dabs so many radii apart instead of one stroke")
      ->check(positive_number());
}

}  // namespace burin
