// Reads glTF 2.0 and GLB: the triangles of all meshes in the scene, transformed by their nodes or skins. This
// is our own reader on top of the JSON library, since tinygltf 2.7, which Debian has, does not decode
// accessors.
#include <burin/base/error.h>
#include <burin/base/srgb.h>
#include <burin/surface/files/colour_byte.h>
#include <burin/surface/files/mesh_formats.h>
#include <burin/surface/files/over_clay.h>
#include <burin/surface/files/unused_count.h>
#include <burin/surface/formats/gltf_document.h>
#include <burin/surface/formats/gltf_skin.h>
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>

namespace burin {
namespace {

using Json = nlohmann::json;
using Values = GltfDocument::Values;

/// A scene may show one mesh many times, but a small file must not be able to exhaust the memory.
std::size_t most_vertices(std::size_t file_bytes) {
  constexpr std::size_t always = std::size_t{1} << 22, ever = std::size_t{1} << 28, times_file = 64;
  return std::min(ever, std::max(always, times_file * file_bytes));
}
constexpr std::size_t most_corners_per_vertex = 8;

constexpr int deepest = 1000;  ///< greatest depth of the tree of nodes

class GltfReader {
 public:
  explicit GltfReader(const GltfDocument& document) : document_(document) {}

  FileMesh read() {
    const Json& json = document_.json();
    seen_.resize(json.value("nodes", Json::array()).size());
    placed_.resize(seen_.size(), Eigen::Affine3d::Identity());
    for (const Json& node : roots()) place_node(node, Eigen::Affine3d::Identity(), 0);
    for (const std::size_t node : shown_) read_node(node);
    if (seen_.empty())
      for (const Json& mesh : json.value("meshes", Json::array()))
        read_mesh(mesh, {Eigen::Affine3d::Identity(), nullptr, weights_of(mesh)});
    for (const auto& [list, one, many] : {std::array{"animations", "animation", "animations"},
                                          std::array{"materials", "material", "materials"}})
      unused_.add(one, many, json.value(list, Json::array()).size());
    unused_.add("texture transform", "texture transforms",
                texture_transforms(json.value("materials", Json())));
    finish_optional();
    file_.mesh.not_used = unused_.text();
    return std::move(file_);
  }

 private:
  /// The number of transforms by which materials change texture coordinates before they look up a texture.
  static std::size_t texture_transforms(const Json& json) {
    if (!json.is_structured()) return 0;
    std::size_t count = json.is_object() && json.contains("KHR_texture_transform") ? 1 : 0;
    for (const Json& one : json) count += texture_transforms(one);
    return count;
  }

  /// The root nodes of the default scene; without scenes, all nodes that are not a child of another node.
  Json roots() const {
    const Json& json = document_.json();
    if (json.contains("scenes") && !json["scenes"].empty())
      return document_.element("scenes", json.value("scene", Json(0U))).value("nodes", Json::array());
    std::vector<bool> is_child(seen_.size());
    for (const Json& node : json.value("nodes", Json::array()))
      for (const Json& child : node.value("children", Json::array())) {
        document_.element("nodes", child);
        is_child[child.get<std::size_t>()] = true;
      }
    Json roots = Json::array();
    for (std::size_t i = 0; i < is_child.size(); ++i)
      if (!is_child[i]) roots.push_back(i);
    return roots;
  }

  /// Where the vertices of a mesh are in the scene: moved by its morph targets, then transformed by its node,
  /// or else by the joints of a skin.
  struct Placement {
    Eigen::Affine3d node;
    const GltfSkin* skin;         ///< null: none
    std::vector<double> weights;  ///< of the morph targets
  };

  void place_node(const Json& index, const Eigen::Affine3d& parent, int depth) {
    const Json& node = document_.element("nodes", index);
    const auto number = index.get<std::size_t>();
    if (seen_[number] || depth > deepest)
      document_.fail(fmt::format("node {}", number), "is a child of several nodes");
    seen_[number] = true;
    const Eigen::Affine3d placed = placed_[number] = parent * placement(node);
    if (node.contains("mesh")) shown_.push_back(number);
    if (has_extension(node, "EXT_mesh_gpu_instancing")) unused_.add("node's instances", "nodes' instances");
    for (const Json& child : node.value("children", Json::array())) place_node(child, placed, depth + 1);
  }

  static std::vector<double> weights_of(const Json& mesh_or_node) {
    return mesh_or_node.value("weights", std::vector<double>());
  }

  void read_node(std::size_t number) {
    const Json& node = document_.json()["nodes"][number];
    const Json& mesh = document_.element("meshes", node["mesh"]);
    Placement placement{placed_[number], nullptr, weights_of(node.contains("weights") ? node : mesh)};
    if (node.contains("skin")) {
      const Json& skin = document_.element("skins", node["skin"]);
      placement.skin =
          &skins_.try_emplace(node["skin"].get<std::size_t>(), document_, skin, placed_).first->second;
    }
    read_mesh(mesh, placement);
  }

  /// The rotation of a quaternion of any length. Eigen's conversion is not used because its bits depend on
  /// the processor.
  static Eigen::Matrix3d rotation(const Vec3d& vector, double scalar) {
    const double twice = 2 / (vector.squaredNorm() + scalar * scalar);
    Eigen::Matrix3d across;  // across * v is the cross product of `vector` and v
    across << 0, -vector.z(), vector.y(), vector.z(), 0, -vector.x(), -vector.y(), vector.x(), 0;
    return Eigen::Matrix3d::Identity() + twice * (scalar * across + across * across);
  }

  static Eigen::Affine3d placement(const Json& node) {
    Eigen::Affine3d placed = Eigen::Affine3d::Identity();
    if (node.contains("matrix")) {
      const auto numbers = node["matrix"].get<std::array<double, 16>>();
      placed.matrix() = Eigen::Map<const Eigen::Matrix4d>(numbers.data());
      placed.makeAffine();
      return placed;
    }
    const auto numbers = [&](const char* name, std::array<double, 4> initial, std::size_t count) {
      if (const auto found = node.find(name); found != node.end())
        for (std::size_t i = 0; i < count; ++i) initial[i] = found->at(i).get<double>();
      return initial;
    };
    const auto t = numbers("translation", {0, 0, 0, 0}, 3), r = numbers("rotation", {0, 0, 0, 1}, 4),
               s = numbers("scale", {1, 1, 1, 0}, 3);
    placed.translate(Vec3d(t[0], t[1], t[2]));
    placed.linear() = rotation(Vec3d(r[0], r[1], r[2]), r[3]);
    placed.scale(Vec3d(s[0], s[1], s[2]));
    return placed;
  }

  static bool has_extension(const Json& of, const char* name) {
    return of.contains("extensions") && of["extensions"].contains(name);
  }

  /// Refuses a primitive that only its compressed data describe. Files may have plain data beside them.
  void expect_plain_data(const Json& primitive, const Json& position) const {
    const Json& accessor = document_.element("accessors", position);
    if (has_extension(primitive, "KHR_draco_mesh_compression") && !accessor.contains("bufferView") &&
        !accessor.contains("sparse"))
      document_.fail("meshes", "are compressed by Draco (KHR_draco_mesh_compression), which is not read");
  }

  /// Vertices of the file. `mirrored`: what placed them turns triangles around.
  struct Vertices {
    std::size_t first, count;
    bool mirrored;
  };

  /// Reads the primitives of a mesh. Those with the same attributes share their vertices, as where each
  /// material has a primitive of its own.
  void read_mesh(const Json& mesh, const Placement& placed) {
    std::map<std::string, Vertices> shared;
    for (const Json& primitive : mesh.value("primitives", Json::array()))
      read_primitive(primitive, placed, shared);
  }

  void read_primitive(const Json& primitive, const Placement& placed,
                      std::map<std::string, Vertices>& shared) {
    const Json attributes = primitive.value("attributes", Json::object());
    const auto mode = primitive.value("mode", 4U);
    if (mode > 6) document_.fail("meshes", fmt::format("have a primitive of the unknown mode {}", mode));
    if (mode < 4) return unused_.add("primitive of points or lines", "primitives of points or lines");
    if (!attributes.contains("POSITION"))
      return unused_.add("primitive without positions", "primitives without positions");
    expect_plain_data(primitive, attributes["POSITION"]);
    const Json targets = primitive.value("targets", Json::array());
    const auto [known, is_new] = shared.try_emplace(attributes.dump() + targets.dump());
    if (is_new) known->second = read_vertices(attributes, targets, placed);
    const auto [first, count, mirrored] = known->second;
    const std::vector<std::size_t> corners = corners_of(primitive, count);
    const std::size_t most = most_corners_per_vertex * most_vertices(document_.size());
    if (file_.mesh.face_vertices.size() + 3 * corners.size() > most)
      document_.fail("meshes",
                     fmt::format("hold more than the {} corners that a file of this size may", most));
    add_triangles(corners, mode, first, mirrored);
  }

  /// Reads the positions, which there must be, and what else is used of the attributes.
  Vertices read_vertices(const Json& attributes, const Json& targets, const Placement& placed) {
    const std::size_t first = file_.places.size();
    Values places = document_.values(attributes["POSITION"]);
    if (places.components != 3) document_.fail("POSITION", "has not three coordinates");
    const std::size_t most = most_vertices(document_.size());
    if (places.size() > most - first)
      document_.fail("meshes",
                     fmt::format("hold more than the {} vertices that a file of this size may", most));
    for (std::size_t i = 0; i < targets.size(); ++i)
      move_by_target(targets[i], i < placed.weights.size() ? placed.weights[i] : 0, places);
    const auto by_skin = placed.skin ? placed.skin->of_vertices(attributes, places.size()) : std::nullopt;
    const auto transform = [&](std::size_t i) { return by_skin ? (*by_skin)[i] : placed.node; };
    for (std::size_t i = 0; i < places.size(); ++i)
      file_.places.push_back(transform(i) * Eigen::Map<const Vec3d>(places.numbers.data() + 3 * i));
    const bool mirrored = places.size() > 0 && transform(0).linear().determinant() < 0;
    read_attributes(attributes, first);
    if (attributes.contains("NORMAL")) unused_.add("normal", "normals", places.size());
    return {first, places.size(), mirrored};
  }

  /// Moves positions by a morph target that is shown; others are counted as not used.
  void move_by_target(const Json& target, double weight, Values& places) {
    if (weight == 0) return unused_.add("morph target", "morph targets");
    if (!target.contains("POSITION")) return;
    const Values moves = document_.values(target["POSITION"]);
    if (moves.numbers.size() != places.numbers.size())
      document_.fail("targets", "have another number of positions than their primitive");
    for (std::size_t i = 0; i < moves.numbers.size(); ++i) places.numbers[i] += weight * moves.numbers[i];
  }

  std::vector<std::size_t> corners_of(const Json& primitive, std::size_t vertices) {
    std::vector<std::size_t> corners;
    if (!primitive.contains("indices")) {
      for (std::size_t i = 0; i < vertices; ++i) corners.push_back(i);
      return corners;
    }
    for (const double index : document_.values(primitive["indices"]).numbers) {
      if (!(index >= 0 && index < static_cast<double>(vertices)))
        document_.fail("indices", fmt::format("name vertex {}, counted from 0, of {}", index, vertices));
      corners.push_back(static_cast<std::size_t>(index));
    }
    return corners;
  }

  /// Adds the triangles of a list (mode 4), strip (5) or fan (6). `mirrored` reverses their orientation.
  void add_triangles(const std::vector<std::size_t>& corners, unsigned mode, std::size_t first,
                     bool mirrored) {
    const std::size_t step = mode == 4 ? 3 : 1;
    for (std::size_t i = 0; i + 2 < corners.size(); i += step) {
      std::size_t a = corners[mode == 6 ? 0 : i], b = corners[i + 1], c = corners[i + 2];
      const bool repeats = a == b || b == c || c == a;
      if (mode != 4 && repeats) continue;
      if (mirrored != (mode == 5 && i % 2 == 1)) std::swap(b, c);
      file_.mesh.face_sizes.push_back(3);
      for (const std::size_t corner : {a, b, c})
        file_.mesh.face_vertices.push_back(static_cast<Index>(first + corner));
    }
  }

  /// Reads the optional attributes of a primitive: texture coordinates, colours and masks.
  void read_attributes(const Json& attributes, std::size_t first) {
    const std::size_t count = file_.places.size() - first;
    const auto values = [&](const char* name, std::size_t least) {
      Values found;
      if (attributes.contains(name)) found = document_.values(attributes[name]);
      const bool fits = found.size() == count && found.components >= least;
      return fits && std::ranges::all_of(found.numbers, [](double v) { return std::isfinite(v); }) ? found
                                                                                                   : Values{};
    };
    if (const Values uv = values("TEXCOORD_0", 2); uv.size() > 0) {
      uv_.resize(first, Vec2f::Zero());
      textured_ += count;
      for (std::size_t i = 0; i < count; ++i)
        uv_.emplace_back(static_cast<float>(uv.numbers[uv.components * i]),
                         static_cast<float>(1 - uv.numbers[uv.components * i + 1]));
    }
    if (const Values colours = values("COLOR_0", 3); colours.size() > 0) {
      file_.mesh.paint.colours.resize(first, {0, 0, 0, 0});
      std::vector<PaintBytes> shown =
          colours_of(colours, [](double light) { return to_srgb(static_cast<float>(light)); });
      if (const Values ink = values("_INK", 4); ink.size() > 0)
        shown = ink_unless_painted_over(shown, colours_of(ink, colour_byte));
      file_.mesh.paint.colours.insert(file_.mesh.paint.colours.end(), shown.begin(), shown.end());
    }
    if (const Values masks = values("_MASK", 1); masks.size() > 0) {
      file_.mesh.paint.masks.resize(first, 1);
      for (std::size_t i = 0; i < count; ++i)
        file_.mesh.paint.masks.push_back(
            static_cast<float>(std::clamp(masks.numbers[masks.components * i], 0.0, 1.0)));
    }
  }

  /// Converts values to bytes; `encode` converts the file's red, green and blue, 0 to 1, to sRGB bytes.
  template <class Encode>
  static std::vector<PaintBytes> colours_of(const Values& values, const Encode& encode) {
    std::vector<PaintBytes> colours(values.size(), {0, 0, 0, 255});
    for (std::size_t i = 0; i < values.numbers.size(); ++i) {
      const std::size_t channel = i % values.components;
      const double value = values.numbers[i];
      if (channel < 4)
        colours[i / values.components][channel] = channel < 3 ? encode(value) : colour_byte(value);
    }
    return colours;
  }

  void finish_optional() {
    const std::size_t vertices = file_.places.size();
    VertexPaint& paint = file_.mesh.paint;
    if (!paint.colours.empty()) paint.colours.resize(vertices, {0, 0, 0, 0});
    if (!paint.masks.empty()) paint.masks.resize(vertices, 1);
    if (textured_ < vertices) return unused_.add("texture coordinate", "texture coordinates", textured_);
    for (const Index vertex : file_.mesh.face_vertices) file_.mesh.corner_uv.push_back(uv_[vertex]);
  }

  const GltfDocument& document_;
  std::vector<bool> seen_;               ///< [node]
  std::vector<Eigen::Affine3d> placed_;  ///< [node] to the scene
  std::map<std::size_t, GltfSkin> skins_;
  std::vector<std::size_t> shown_;  ///< nodes of the scene that have meshes, in its order
  FileMesh file_;
  std::vector<Vec2f> uv_;
  std::size_t textured_ = 0;  ///< number of vertices with texture coordinates
  UnusedCount unused_;
};

}  // namespace

FileMesh read_gltf(const std::filesystem::path& path) {
  const GltfDocument document(path);
  try {
    return GltfReader(document).read();
  } catch (const Json::exception&) {
    throw FileError(path.string(), "is not glTF: a member is of another type");
  }
}

}  // namespace burin
