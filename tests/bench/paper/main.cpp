// Section 5 of R. Schmidt, Stroke Parameterization, 2013, on Burin's charts: Figures 10 to 14 as one page.
#include <burin/base/error.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "figures.h"

namespace {

void write_page(const std::string& path, bool quick) {
  using namespace burin::paper;
  const Scenes scenes(quick);
  Page page("Stroke charts: the evaluation of the paper");
  distance_figure(page, scenes);
  dncp_figure(page, scenes);
  arap_figure(page, scenes);
  times_figure(page, scenes, quick ? 3 : 30, quick ? 12 : 70);
  hairpin_figure(page, scenes);
  page.write(path);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Reproduces Figures 10 to 14 of the paper on this project's meshes.", "burin_paper_bench");
  std::string path = "paper.html";
  bool quick = false;
  app.add_option("--out", path, "page to write")->capture_default_str();
  app.add_flag("--quick", quick, "small meshes and few strokes: to see that it runs");
  CLI11_PARSE(app, argc, argv);
  try {
    write_page(path, quick);
    return 0;
  } catch (const burin::Error& error) {
    fmt::print(stderr, "burin_paper_bench: {}\n", error.what());
    return 1;
  }
}
