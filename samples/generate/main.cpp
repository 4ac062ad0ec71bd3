// burin_samples FOLDER: writes the sample meshes, strokes and stamps into a folder.
#include <burin/subdiv/refine.h>
#include <burin/surface/surface.h>
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <filesystem>

#include "cage_file.h"
#include "ewer_cage.h"
#include "plait.h"
#include "sample_recordings.h"
#include "sample_strokes.h"
#include "scales_stamp.h"
#include "thorn_stamp.h"
#include "tread_stamps.h"

namespace {

namespace fs = std::filesystem;

void write_samples(const fs::path& folder) {
  for (const char* name : {"meshes", "strokes", "recordings", "stamps"})
    fs::create_directories(folder / name);
  const burin::PolygonMesh cage = burin::samples::ewer_cage();
  burin::samples::write_cage(folder / "meshes/ewer.obj", "A ewer, to be refined by Catmull-Clark", cage);
  burin::samples::write_cage(folder / "meshes/plait.obj", "A period of a plait, to be bent along strokes",
                             burin::samples::plait());
  burin::samples::write_scales(folder / "stamps/scales.exr");
  burin::samples::write_treads(folder / "stamps");
  burin::samples::write_thorn(folder / "stamps/thorn.exr");
  // Level 4 is within 2e-5 units of the limit surface: over an edge of length e the surface of curvature
  // radius R bulges by e^2 / 8R, about 0.011^2 / (8 * 0.7).
  const auto ewer = burin::make_surface(burin::refine(cage, burin::SubdivisionScheme::catmull_clark, 4));
  burin::samples::write_sample_strokes(folder / "strokes", ewer);
  burin::samples::write_recordings(folder / "recordings", ewer);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: burin_samples FOLDER\n");
    return 2;
  }
  try {
    write_samples(argv[1]);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "burin_samples: {}\n", error.what());
    return 2;
  }
}
