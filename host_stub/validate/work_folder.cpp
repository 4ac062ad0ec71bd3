// Makes a temporary folder with a stamp image and a solid for the checks.
#include "validate/work_folder.h"

#include <burin/level_set/mesh_solid.h>
#include <burin/level_set/solid_mesh.h>
#include <burin/stamp/files/picture.h>

#include <array>
#include <cstdlib>
#include <string>

#include "system/child_tasks.h"

namespace burin::validate {
namespace {

/// An image of soft hills that tiles.
void write_stamp(const std::filesystem::path& path) {
  Picture picture{32, 32, {}};
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      const int rise = (x < 16 ? x : 31 - x) * (y < 16 ? y : 31 - y);
      picture.rgb.insert(picture.rgb.end(), 3, static_cast<std::uint8_t>(rise));
    }
  write_png(path, picture);
}

/// A box as an OpenVDB file.
void write_solid(const std::filesystem::path& path) {
  TriangleMesh box;
  for (int corner = 0; corner < 8; ++corner)
    box.positions.emplace_back(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
  box.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                   {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  write_vdb(path, std::array{solid_of(box, 0.1)});
}

/// The folder for temporary files. Throws FileError if there is none.
std::filesystem::path temporary_folder() {
  std::error_code error;
  std::filesystem::path folder = std::filesystem::temp_directory_path(error);
  if (!error) return folder;
  const char* name = std::getenv("TMPDIR");
  throw FileError(name ? name : "/tmp", "is no folder for temporary files (TMPDIR)");
}

}  // namespace

WorkFolder::WorkFolder() {
  std::string name = (temporary_folder() / "burin-validate-XXXXXX").string();
  if (!mkdtemp(name.data())) throw FileError(name, "the folder cannot be made");
  path_ = name;
  write_stamp(stamp());
}

WorkFolder::~WorkFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

void WorkFolder::add_solid() const {
  const ChildResult made = run_in_children(1, 1, 30, [this](std::size_t) {
    write_solid(path_ / "solid.vdb");
    return std::string();
  })[0];
  if (made.end != ChildResult::End::whole) throw Error("no solid can be made for the checks: " + made.text);
}

Subject WorkFolder::subject(const std::filesystem::path& module, std::uint64_t seed) const {
  return {std::filesystem::absolute(module), path_, stamp(), path_ / "solid.vdb", seed};
}

}  // namespace burin::validate
