// Parses the options of displacement maps, bakes and writes the map, and warns of its defects.
#include "options/bake_option.h"

#include <burin/base/error.h>
#include <burin/base/text/quoted_word.h>
#include <burin/stamp/float_image.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "options/options.h"
#include "system/output_file.h"

namespace burin {
namespace {

void read_axes(const std::string& text, BakeSettings& settings) {
  settings.object_space = text == "object";
  const auto axes = math::vector_axes(settings.object_space ? "x,y,z" : text);
  if (!axes)
    throw CLI::ValidationError("--bake-axes",
                               "takes x, y and z in any order, as x,z,-y, or blender, cycles, "
                               "mudbox or object, not " +
                                   quoted_word(text));
  settings.axes = *axes;
}

}  // namespace

void add_bake_options(CLI::App& command, BakeOptions& options) {
  auto* bake = command
                   .add_option("--bake", options.path,
                               "displacement map to write, over the mesh's texture coordinates")
                   ->type_name("FILE.exr");
  command.add_option("--bake-size", options.settings.size, "texels a side of the map")
      ->check(CLI::Range(1, 16384))
      ->capture_default_str()
      ->needs(bake);
  auto* vectors = command
                      .add_flag("--bake-vectors", options.settings.vectors,
                                "vectors along tangent, bitangent and normal instead of heights")
                      ->needs(bake);
  command
      .add_option_function<std::string>(
          "--bake-axes", [&options](const std::string& text) { read_axes(text, options.settings); },
          "what red, green and blue of vectors hold: x along the tangent, y the bitangent, z the normal, as\n"
          "x,y,z or x,z,-y; or as a program takes it: blender, cycles, mudbox; or object, the object's x, y, "
          "z")
      ->type_name("AXES")
      ->needs(vectors);
  command.add_option("--bake-middle", options.settings.middle, "value of no displacement")
      ->check(finite_number())
      ->capture_default_str()
      ->needs(bake);
}

void check_bake_path(const BakeOptions& options) {
  if (!options.asked()) return;
  check_output_path(options.path);
  if (std::filesystem::path(options.path).extension() != ".exr")
    throw FileError(options.path, "maps are written as .exr files");
}

Json write_map(const BakeOptions& options, TriangleMesh base, std::span<const Vec3f> displaced) {
  const BakedMap map = bake_displacement(std::move(base), displaced, options.settings);
  if (map.overlaps > 0) {
    warn(fmt::format(
        "{}: texture coordinates overlap at {} texels, where the first triangle's displacement holds",
        options.path, map.overlaps));
  }
  if (map.cut > 0) {
    warn(fmt::format("{}: {} triangles reach beyond texture coordinates 0 to 1, which cut them off",
                     options.path, map.cut));
  }
  if (map.without_area > 0) {
    warn(fmt::format("{}: {} displaced triangles have no area in texture coordinates, and are not in the map",
                     options.path, map.without_area));
  }
  write_exr(options.path, map.image);
  return {{"file", options.path},           {"size", map.image.width},
          {"channels", map.image.channels}, {"overlapping_texels", map.overlaps},
          {"triangles_cut", map.cut},       {"triangles_without_area", map.without_area}};
}

}  // namespace burin
