#include <assimp/mesh.h>
#include <assimp/scene.h>
#include <burin/base/error.h>
#include <burin/surface/mesh_formats.h>
#include <burin/surface/weld.h>

#include <algorithm>
#include <assimp/Importer.hpp>

namespace burin {
namespace {

void append(const aiMesh& from, PolygonMesh& mesh) {
  const auto first = static_cast<Index>(mesh.positions.size());
  for (unsigned i = 0; i < from.mNumVertices; ++i)
    mesh.positions.emplace_back(from.mVertices[i].x, from.mVertices[i].y, from.mVertices[i].z);
  for (unsigned i = 0; i < from.mNumFaces; ++i) {
    const aiFace& face = from.mFaces[i];
    mesh.face_sizes.push_back(face.mNumIndices);
    for (unsigned corner = 0; corner < face.mNumIndices; ++corner)
      mesh.face_vertices.push_back(first + face.mIndices[corner]);
  }
}

/// Makes one vertex of all at one place, in order of first appearance.
void weld(PolygonMesh& mesh) {
  const std::vector<Index> first = first_at_place(mesh.positions);
  std::vector<Index> welded(first.size());
  std::vector<Vec3f> positions;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] == i) positions.push_back(mesh.positions[i]);
    welded[i] = first[i] == i ? static_cast<Index>(positions.size() - 1) : welded[first[i]];
  }
  for (Index& vertex : mesh.face_vertices) vertex = welded[vertex];
  mesh.positions = std::move(positions);
}

}  // namespace

PolygonMesh read_stl(const std::filesystem::path& path) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(path.string(), 0);
  if (!scene) {
    std::string error = importer.GetErrorString();
    std::replace(error.begin(), error.end(), '\n', ' ');
    throw FileError(path.string(), error);
  }
  PolygonMesh mesh;
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) append(*scene->mMeshes[i], mesh);
  weld(mesh);
  return mesh;
}

}  // namespace burin
