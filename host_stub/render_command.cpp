// The command `burin render`: draws a shaded picture of a surface.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.h"
#include "input/mesh_input.h"
#include "options/view.h"
#include "pictures/painted.h"
#include "pictures/render.h"
#include "system/output_file.h"

namespace burin::command {
namespace {

struct RenderOptions {
  MeshOptions mesh;
  ViewOptions view;
  std::string png;
  bool json = false;
};

void run(const RenderOptions& options) {
  check_output_path(options.png);
  const LoadedSurface loaded = load_surface_on_console(options.mesh);
  const Picker picker(loaded.surface);
  ProgressBar bar;
  write_png(options.png, render(loaded.surface, picker, whole_view(loaded.surface, options.view),
                                painted(loaded.paint), bar.progress()));
  if (options.json) {
    write_result(json_text({{"mesh", mesh_json(options.mesh, loaded)}, {"png", options.png}}));
  } else {
    write_result(fmt::format("{}\n{}: {} x {} pixels\n", mesh_text(options.mesh, loaded), options.png,
                             options.view.width, options.view.height));
  }
}

}  // namespace

void add_render(CLI::App& app) {
  const auto options = std::make_shared<RenderOptions>();
  CLI::App& command = *app.add_subcommand("render", "draw a shaded picture of a surface");
  add_mesh_options(command, options->mesh);
  add_view_options(command, options->view);
  command.add_option("--png", options->png, "picture to write")->required()->type_name("FILE");
  command.add_flag("--json", options->json, "write JSON to the standard output");
  command.callback([options] { run(*options); });
}

}  // namespace burin::command
