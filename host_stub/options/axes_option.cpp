// Parses which axis is up in the files of a command, and computes the rotations between y-up and z-up axes.
#include "options/axes_option.h"

#include <burin/base/error.h>
#include <burin/base/text/lower_case.h>
#include <burin/base/text/quoted_word.h>

#include <CLI/CLI.hpp>
#include <filesystem>

namespace burin {
namespace {

Axes parse_axes(const std::string& option, const std::string& name) {
  if (name == "as-is") return Axes::as_is;
  if (name == "y-up") return Axes::y_up;
  if (name == "z-up") return Axes::z_up;
  throw CLI::ValidationError(option, "takes as-is, y-up or z-up, not " + quoted_word(name));
}

void add_stroke_axes(CLI::App& command, Axes& axes) {
  command
      .add_option_function<std::string>(
          "--stroke-axes", [&axes](const std::string& name) { axes = parse_axes("--stroke-axes", name); },
          "which way is up in the recordings: y-up or z-up; as in the mesh unless given")
      ->type_name("UP");
}

bool is_gltf(const std::string& path) {
  const std::string extension = in_lower_case(std::filesystem::path(path).extension().string());
  return extension == ".glb" || extension == ".gltf";
}

/// The axes of the mesh file. Throws Error if they are unknown.
Axes known_axes(const AxesOptions& options, const std::string& mesh_path, const std::string& option) {
  if (options.mesh != Axes::as_is) return options.mesh;
  if (is_gltf(mesh_path)) return Axes::y_up;
  throw Error(option + ": which way is up in " + quoted_word(mesh_path) +
              " is not known; --axes y-up or z-up tells");
}

Eigen::Matrix3d turn(Axes from, Axes to) {
  Eigen::Matrix3d z_to_y;
  z_to_y << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  if (from == to) return Eigen::Matrix3d::Identity();
  return to == Axes::y_up ? z_to_y : Eigen::Matrix3d(z_to_y.transpose());
}

}  // namespace

void add_axes_options(CLI::App& command, AxesOptions& options) {
  command
      .add_option_function<std::string>(
          "--axes",
          [&options](const std::string& text) {
            const std::size_t colon = text.find(':');
            options.mesh = parse_axes("--axes", text.substr(0, colon));
            if (colon != std::string::npos) options.saved = parse_axes("--axes", text.substr(colon + 1));
          },
          "which way is up in the mesh and is to be in what is saved, each as-is (not turned), y-up or "
          "z-up;\n"
          "saved as the mesh unless given, but a .glb y-up where the mesh's is given")
      ->type_name("MESH[:SAVED]");
  add_stroke_axes(command, options.strokes);
}

void add_drawing_axes_options(CLI::App& command, AxesOptions& options) {
  command
      .add_option_function<std::string>(
          "--axes", [&options](const std::string& name) { options.mesh = parse_axes("--axes", name); },
          "which way is up in the mesh: y-up or z-up, for --stroke-axes")
      ->type_name("UP");
  add_stroke_axes(command, options.strokes);
}

Eigen::Matrix3d turn_of_strokes(const AxesOptions& options, const std::string& mesh_path) {
  if (options.strokes == Axes::as_is) return Eigen::Matrix3d::Identity();
  return turn(options.strokes, known_axes(options, mesh_path, "--stroke-axes"));
}

Eigen::Matrix3d turn_of_saved(const AxesOptions& options, const std::string& mesh_path,
                              const std::string& saved_path) {
  const bool is_told = options.mesh != Axes::as_is;
  const Axes saved = options.saved.value_or(is_told && is_gltf(saved_path) ? Axes::y_up : Axes::as_is);
  if (saved == Axes::as_is) return Eigen::Matrix3d::Identity();
  return turn(known_axes(options, mesh_path, "--axes"), saved);
}

}  // namespace burin
