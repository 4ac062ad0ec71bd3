#pragma once
#include <burin/surface/formats/gltf_document.h>

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <vector>

namespace burin {

/// The joints that move the vertices of a mesh [Khronos, glTF 2.0, section 3.7.3.2]. A mesh with a skin lies
/// where its joints are, wherever its own node is.
class GltfSkin {
 public:
  /// `placed`: the transforms of the document's nodes to the scene, by node. Throws FileError for joints that
  /// are no nodes, and for too few inverse bind matrices.
  GltfSkin(const GltfDocument& document, const nlohmann::json& skin,
           const std::vector<Eigen::Affine3d>& placed);

  /// The transforms of the vertices of a primitive: the means of those of their joints, by weights. Nothing
  /// if the attributes name no joints. Throws FileError for joints that the skin lacks.
  std::optional<std::vector<Eigen::Affine3d>> of_vertices(const nlohmann::json& attributes,
                                                          std::size_t vertices) const;

 private:
  const GltfDocument& document_;
  std::vector<Eigen::Affine3d> joints_;  ///< from the mesh to the scene
};

}  // namespace burin
