// Places vertices by the joints of a skin, in O(vertices): linear blend skinning in the pose of the nodes.
#include <burin/surface/formats/gltf_skin.h>
#include <fmt/format.h>

namespace burin {

using Json = nlohmann::json;

GltfSkin::GltfSkin(const GltfDocument& document, const Json& skin, const std::vector<Eigen::Affine3d>& placed)
    : document_(document) {
  constexpr std::size_t matrix_size = 16;
  GltfDocument::Values inverse;
  if (skin.contains("inverseBindMatrices")) inverse = document.values(skin["inverseBindMatrices"]);
  const Json joints = skin.value("joints", Json::array());
  if (inverse.components != 0 && (inverse.components != matrix_size || inverse.size() < joints.size()))
    document.fail("inverseBindMatrices", "are not a matrix for each joint");
  for (const Json& joint : joints) {
    document.element("nodes", joint);
    Eigen::Affine3d from_mesh = Eigen::Affine3d::Identity();
    if (inverse.components != 0)
      from_mesh.matrix() =
          Eigen::Map<const Eigen::Matrix4d>(inverse.numbers.data() + matrix_size * joints_.size());
    from_mesh.makeAffine();
    joints_.push_back(placed[joint.get<std::size_t>()] * from_mesh);
  }
}

std::optional<std::vector<Eigen::Affine3d>> GltfSkin::of_vertices(const Json& attributes,
                                                                  std::size_t vertices) const {
  std::vector<Eigen::Matrix4d> sums(vertices, Eigen::Matrix4d::Zero());
  for (int set = 0;; ++set) {
    const std::string joints_name = fmt::format("JOINTS_{}", set),
                      weights_name = fmt::format("WEIGHTS_{}", set);
    if (!attributes.contains(joints_name) || !attributes.contains(weights_name)) {
      if (set == 0) return std::nullopt;
      break;
    }
    const GltfDocument::Values joints = document_.values(attributes[joints_name]),
                               weights = document_.values(attributes[weights_name]);
    if (joints.numbers.size() != weights.numbers.size() || joints.size() != vertices)
      document_.fail(joints_name, "has another count than the weights or the positions");
    for (std::size_t i = 0; i < joints.numbers.size(); ++i) {
      const double joint = joints.numbers[i];
      if (!(joint >= 0 && joint < static_cast<double>(joints_.size())))
        document_.fail(joints_name,
                       fmt::format("names joint {}, counted from 0, of {}", joint, joints_.size()));
      sums[i / joints.components] += weights.numbers[i] * joints_[static_cast<std::size_t>(joint)].matrix();
    }
  }
  std::vector<Eigen::Affine3d> made(vertices, Eigen::Affine3d::Identity());
  for (std::size_t i = 0; i < vertices; ++i) {
    // Weights that do not sum to 1 must not scale.
    const double weight = sums[i](3, 3);
    if (weight > 0) made[i].matrix() = sums[i] / weight;
  }
  return made;
}

}  // namespace burin
