#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace burin::fuzz {

/// Contents of files.
using Seeds = std::vector<std::string>;

Seeds obj_seeds();
Seeds ply_seeds();
Seeds stl_seeds();
Seeds off_seeds();
Seeds gltf_seeds();

/// A painted mesh in the format that the file's name asks for, by write_mesh.
void write_mesh_seeds(const std::filesystem::path& file);

}  // namespace burin::fuzz
