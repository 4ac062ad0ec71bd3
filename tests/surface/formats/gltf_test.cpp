#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/surface/mesh_file.h>
#include <burin/surface/triangulate.h>
#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "support/shared_data.h"
#include "surface/test_meshes.h"

namespace burin {
namespace {

using Json = nlohmann::json;

/// A document whose buffer lies in a file beside it.
class Document {
 public:
  Json json = {{"asset", {{"version", "2.0"}}},
               {"meshes", {{{"primitives", Json::array()}}}},
               {"accessors", Json::array()},
               {"bufferViews", Json::array()}};
  std::string bytes;

  template <class Number>
  std::size_t view(const std::vector<Number>& numbers, std::size_t stride = 0) {
    bytes.resize((bytes.size() + 3) / 4 * 4);
    Json view = {
        {"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", sizeof(Number) * numbers.size()}};
    if (stride > 0) view["byteStride"] = stride;
    bytes.append(reinterpret_cast<const char*>(numbers.data()), sizeof(Number) * numbers.size());
    json["bufferViews"].push_back(view);
    return json["bufferViews"].size() - 1;
  }

  std::size_t accessor(const Json& members) {
    json["accessors"].push_back(members);
    return json["accessors"].size() - 1;
  }

  template <class Number>
  std::size_t values(const std::vector<Number>& numbers, int type, const char* shape, std::size_t count,
                     bool normalised = false) {
    return accessor({{"bufferView", view(numbers)},
                     {"componentType", type},
                     {"type", shape},
                     {"count", count},
                     {"normalized", normalised}});
  }

  Json& primitive(const Json& attributes) {
    json["meshes"][0]["primitives"].push_back({{"attributes", attributes}});
    return json["meshes"][0]["primitives"].back();
  }

  PolygonMesh read() {
    write_file_whole(folder_.path() / "a b.bin", [&](std::ostream& out) { out << bytes; });
    if (!json.contains("buffers")) json["buffers"] = {{{"uri", "a%20b.bin"}, {"byteLength", bytes.size()}}};
    write_file_whole(path(), [&](std::ostream& out) { out << json.dump(); });
    return read_mesh(path());
  }

  std::string message() {
    try {
      read();
    } catch (const FileError& error) {
      return std::string(error.what()).substr(folder_.path().string().size() + 1);
    }
    return "no error";
  }

  std::filesystem::path path() const { return folder_.path() / "a.gltf"; }

 private:
  test::TemporaryFolder folder_;
};

constexpr int byte = 5120, ubyte = 5121, ushort = 5123, floating = 5126;
const std::vector<float> corners = {0, 0, 0, 1, 0, 0, 0, 1, 0};
const std::vector<Vec3f> corner_places = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

TEST(ReadGltf, ReadsPrimitivesOfEveryKindOfTriangles) {
  Document document;
  const std::vector<float> square = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
  const auto places = [&] { return document.values(square, floating, "VEC3", 4); };
  document.primitive({{"POSITION", places()}})["indices"] =
      document.values(std::vector<std::uint16_t>{0, 1, 2, 1, 3, 2}, ushort, "SCALAR", 6);
  document.primitive({{"POSITION", places()}})["mode"] = 5;
  Json& fan = document.primitive({{"POSITION", places()}});
  fan["mode"] = 6;
  fan["indices"] = document.values(std::vector<std::uint8_t>{0, 1, 3, 2}, ubyte, "SCALAR", 4);
  document.primitive({{"POSITION", places()}})["mode"] = 1;
  const PolygonMesh mesh = document.read();
  EXPECT_EQ(mesh.positions.size(), 12u);
  EXPECT_EQ(mesh.face_vertices,
            (std::vector<Index>{0, 1, 2, 1, 3, 2, 4, 5, 6, 5, 7, 6, 8, 9, 11, 8, 11, 10}));
  EXPECT_EQ(mesh.not_used, "1 primitive of points or lines");
}

// Programs write a primitive for each material, with indices of its own into the same vertices.
TEST(ReadGltf, ReadsVerticesThatPrimitivesShareOnce) {
  Document document;
  const std::vector<float> square = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
  const std::size_t places = document.values(square, floating, "VEC3", 4);
  const std::size_t masks = document.values(std::vector<float>{0, 1, 1, 1}, floating, "SCALAR", 4);
  const auto add = [&](const Json& attributes, const std::vector<std::uint8_t>& indices) {
    document.primitive(attributes)["indices"] = document.values(indices, ubyte, "SCALAR", 3);
  };
  add({{"POSITION", places}}, {0, 1, 2});
  add({{"POSITION", places}}, {1, 3, 2});
  add({{"POSITION", places}, {"_MASK", masks}}, {0, 1, 2});
  document.json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"translation", {0, 0, 1}}}};
  const PolygonMesh mesh = document.read();
  EXPECT_EQ(mesh.positions.size(), 16u) << "other attributes and other nodes have vertices of their own";
  EXPECT_EQ(mesh.face_vertices,
            (std::vector<Index>{0, 1, 2, 1, 3, 2, 4, 5, 6, 8, 9, 10, 9, 11, 10, 12, 13, 14}));
  EXPECT_EQ(mesh.paint.masks[4], 0);
}

TEST(ReadGltf, ReadsQuantisedInterleavedAndSparseNumbers) {
  Document document;
  document.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  // Places as normalised bytes and texture coordinates as normalised shorts, eight bytes a vertex.
  const std::vector<std::uint8_t> vertices = {0,   0,   0, 0, 0, 0,   255, 255, 127, 0, 0,   0,
                                              255, 255, 0, 0, 0, 129, 0,   0,   0,   0, 255, 255};
  const std::size_t view = document.view(vertices, 8);
  const std::size_t places = document.accessor(
      {{"bufferView", view}, {"componentType", byte}, {"normalized", true}, {"type", "VEC3"}, {"count", 3}});
  const std::size_t uv = document.accessor({{"bufferView", view},
                                            {"byteOffset", 4},
                                            {"componentType", ushort},
                                            {"normalized", true},
                                            {"type", "VEC2"},
                                            {"count", 3}});
  document.primitive({{"POSITION", places}, {"TEXCOORD_0", uv}});
  const PolygonMesh mesh = document.read();
  EXPECT_EQ(mesh.positions, (std::vector<Vec3f>{{0, 0, 0}, {1, 0, 0}, {0, -1, 0}}));
  EXPECT_EQ(mesh.corner_uv, (std::vector<Vec2f>{{0, 0}, {1, 1}, {0, 0}}));

  Document sparse;
  const std::size_t at = sparse.view(std::vector<std::uint8_t>{1, 2}),
                    to = sparse.view(std::vector<float>(corners.begin() + 3, corners.end()));
  sparse.primitive(
      {{"POSITION", sparse.accessor({{"componentType", floating},
                                     {"type", "VEC3"},
                                     {"count", 3},
                                     {"sparse",
                                      {{"count", 2},
                                       {"indices", {{"bufferView", at}, {"componentType", ubyte}}},
                                       {"values", {{"bufferView", to}}}}}})}});
  EXPECT_EQ(sparse.read().positions, corner_places);
}

TEST(ReadGltf, PlacesMeshesAsTheSceneDoes) {
  Document document;
  document.primitive({{"POSITION", document.values(corners, floating, "VEC3", 3)}});
  document.json["nodes"] = {{{"children", {1, 2}}, {"translation", {1, 2, 3}}, {"scale", {2, 2, 2}}},
                            {{"mesh", 0}, {"rotation", {0, 0, 0.70710678, 0.70710678}}},
                            {{"mesh", 0}, {"matrix", {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 0, 0, 1}}},
                            {{"mesh", 0}}};
  document.json["scenes"] = {{{"nodes", {3}}}, {{"nodes", {0}}}};
  document.json["scene"] = 1;
  const PolygonMesh mesh = document.read();
  ASSERT_EQ(mesh.positions.size(), 6u);
  EXPECT_LT((mesh.positions[1] - Vec3f(1, 4, 3)).norm(), 1e-6F);
  EXPECT_LT((mesh.positions[4] - Vec3f(9, 2, 3)).norm(), 1e-6F);
  EXPECT_EQ(mesh.face_vertices, (std::vector<Index>{0, 1, 2, 3, 5, 4}));  // mirrored, so turned
}

// Two joints, of which one is turned and moved: what is bound to it goes with it, the mesh's own node does
// not matter, and a vertex between is their mean.
TEST(ReadGltf, PlacesMeshesWithSkinsByTheirJoints) {
  Document document;
  const std::vector<float> inverse = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,  0, 1,
                                      1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1};
  Json& primitive = document.primitive({{"POSITION", document.values(corners, floating, "VEC3", 3)}});
  primitive["attributes"]["JOINTS_0"] =
      document.values(std::vector<std::uint8_t>{0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, ubyte, "VEC4", 3);
  primitive["attributes"]["WEIGHTS_0"] =
      document.values(std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 0.5, 0.5, 0, 0}, floating, "VEC4", 3);
  document.json["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"scale", {7, 7, 7}}},
                            {{"children", {2}}, {"translation", {10, 0, 0}}},
                            {{"translation", {0, 1, 0}}, {"rotation", {0, 0, 0.70710678, 0.70710678}}}};
  document.json["skins"] = {
      {{"joints", {1, 2}}, {"inverseBindMatrices", document.values(inverse, floating, "MAT4", 2)}}};
  const PolygonMesh mesh = document.read();
  ASSERT_EQ(mesh.positions.size(), 3u);
  EXPECT_LT((mesh.positions[0] - Vec3f(10, 0, 0)).norm(), 1e-6F);
  EXPECT_LT((mesh.positions[1] - Vec3f(11, 2, 0)).norm(), 1e-6F) << "(1, -1) turned by a right angle";
  EXPECT_LT((mesh.positions[2] - Vec3f(10, 1, 0)).norm(), 1e-6F);
  EXPECT_EQ(mesh.not_used, "");
  document.json["skins"][0]["joints"] = {1};
  EXPECT_EQ(document.message(), "a.gltf:JOINTS_0: names joint 1, counted from 0, of 1");
  document.json["skins"][0]["joints"] = {1, 9};
  EXPECT_NE(document.message(), "no error");
  document.json["skins"][0]["joints"] = {1, 2, 1};
  EXPECT_EQ(document.message(), "a.gltf:inverseBindMatrices: are not a matrix for each joint");
}

TEST(ReadGltf, MovesPositionsByTheMorphTargetsThatAreShown) {
  Document document;
  Json& primitive = document.primitive({{"POSITION", document.values(corners, floating, "VEC3", 3)}});
  const std::vector<float> up = {0, 0, 0, 0, 0, 0, 0, 0, 2};
  const std::size_t target = document.values(up, floating, "VEC3", 3);
  primitive["targets"] = {{{"POSITION", target}}, {{"POSITION", target}}, {{"NORMAL", target}}};
  EXPECT_EQ(document.read().positions, corner_places);
  EXPECT_EQ(document.read().not_used, "3 morph targets");
  document.json["meshes"][0]["weights"] = {0.5, 0, 1};
  EXPECT_EQ(document.read().positions[2], Vec3f(0, 1, 1));
  EXPECT_EQ(document.read().not_used, "1 morph target");
  document.json["nodes"] = {{{"mesh", 0}, {"weights", {0, 0.25}}}};
  EXPECT_EQ(document.read().positions[2], Vec3f(0, 1, 0.5F)) << "the node's weights count";
  document.json["accessors"][target]["count"] = 2;
  EXPECT_EQ(document.message(), "a.gltf:targets: have another number of positions than their primitive");
}

TEST(ReadGltf, CountsNodesWhoseInstancesItLeavesOut) {
  Document document;
  document.primitive({{"POSITION", document.values(corners, floating, "VEC3", 3)}});
  document.json["nodes"] = {
      {{"mesh", 0}, {"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", Json::object()}}}}}}};
  EXPECT_EQ(document.read().not_used, "1 node's instances");
}

TEST(ReadGltf, CountsTransformsOfTextureCoordinates) {
  Document document;
  document.primitive({{"POSITION", document.values(corners, floating, "VEC3", 3)}});
  const Json moved = {{"index", 0}, {"extensions", {{"KHR_texture_transform", {{"scale", {2, 2}}}}}}};
  document.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", moved}}}},
                                {{"normalTexture", moved}, {"occlusionTexture", {{"index", 0}}}}};
  EXPECT_EQ(document.read().not_used, "2 materials, 2 texture transforms");
}

TEST(ReadGltf, ReadsLinearColours) {
  Document document;
  const std::size_t colours =
      document.values(std::vector<std::uint16_t>{65535, 14025, 0, 65535, 0, 0, 0, 32768, 0, 0, 65535, 0},
                      ushort, "VEC4", 3, true);
  document.primitive({{"POSITION", document.values(corners, floating, "VEC3", 3)}, {"COLOR_0", colours}});
  using Colours = std::vector<std::array<std::uint8_t, 4>>;
  EXPECT_EQ(document.read().paint.colours, (Colours{{255, 127, 0, 255}, {0, 0, 0, 128}, {0, 0, 255, 0}}));
}

TEST(ReadGltf, RefusesWhatItCannotRead) {
  const auto with = [](const std::function<void(Document&)>& change) {
    Document document;
    document.primitive({{"POSITION", document.values(corners, floating, "VEC3", 3)}});
    change(document);
    return document.message();
  };
  const auto required = [&](const char* name) {
    return with([&](Document& d) { d.json["extensionsRequired"] = {name}; });
  };
  EXPECT_EQ(with([](Document&) {}), "no error");
  EXPECT_EQ(required("KHR_draco_mesh_compression"),
            "a.gltf: is compressed by Draco (KHR_draco_mesh_compression), which is not read");
  EXPECT_EQ(required("EXT_meshopt_compression"),
            "a.gltf: is compressed by meshoptimizer (EXT_meshopt_compression), which is not read");
  EXPECT_EQ(with([](Document& d) {
              d.json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] =
                  Json::object();
              d.json["accessors"][0].erase("bufferView");
            }),
            "a.gltf:meshes: are compressed by Draco (KHR_draco_mesh_compression), which is not read");
  EXPECT_EQ(with([](Document& d) { d.json["meshes"][0]["primitives"][0]["mode"] = 7; }),
            "a.gltf:meshes: have a primitive of the unknown mode 7");
  EXPECT_EQ(required("X_y"), "a.gltf: needs the extension 'X_y', which is not known");
  EXPECT_EQ(with([](Document& d) { d.json["asset"]["version"] = "1.0"; }),
            "a.gltf: is not glTF of version 2");
  EXPECT_EQ(with([](Document& d) { d.json["accessors"][0]["count"] = 4; }),
            "a.gltf:accessor 0: reaches beyond its buffer view");
  EXPECT_EQ(with([](Document& d) { d.json["bufferViews"][0]["byteLength"] = 1000; }),
            "a.gltf:accessor 0: its buffer view reaches beyond the buffer");
  EXPECT_EQ(with([](Document& d) {
              d.json["accessors"][0].erase("bufferView");
              d.json["accessors"][0]["count"] = 4000000000U;
            }),
            "a.gltf:accessor 0: has 4000000000 elements, more than the file has bytes");
  EXPECT_EQ(with([](Document& d) {
              d.json["meshes"][0]["primitives"][0]["indices"] =
                  d.values(std::vector<std::uint8_t>{0, 1, 3}, ubyte, "SCALAR", 3);
            }),
            "a.gltf:indices: name vertex 3, counted from 0, of 3");
  EXPECT_EQ(with([](Document& d) {
              d.json["nodes"] = {{{"children", {1}}}, {{"children", {0}}}};
            }),
            "a.gltf: has no face");
  EXPECT_EQ(with([](Document& d) {
              d.json["scenes"] = {{{"nodes", {0, 0}}}};
              d.json["nodes"] = {{{"mesh", 0}}};
            }),
            "a.gltf:node 0: is a child of several nodes");
  EXPECT_EQ(with([](Document& d) {
              d.json["buffers"] = {{{"uri", "../x.bin"}, {"byteLength", 36}}};
            }),
            "a.gltf: buffer 0 is '../x.bin', which is no file beside this one");
  EXPECT_EQ(with([](Document& d) { d.json["meshes"] = 3; }),
            "a.gltf: is not glTF: a member is of another type");
}

/// A small file that shows the same vertices so often that they take gigabytes.
TEST(ReadGltf, IsNotLedToAskForMuchMemoryByASmallFile) {
  const auto message = [](std::size_t vertices, std::size_t indices, int primitives = 1000) {
    Document document;
    document.bytes.resize(100 * static_cast<std::size_t>(primitives));
    const auto vertex_places =
        document.accessor({{"componentType", floating}, {"type", "VEC3"}, {"count", vertices}});
    const auto triangle_corners =
        document.accessor({{"componentType", ubyte}, {"type", "SCALAR"}, {"count", indices}});
    for (int i = 0; i < primitives; ++i)
      document.primitive({{"POSITION", vertex_places}, {"_ANOTHER", i}})["indices"] = triangle_corners;
    return document.message();
  };
  EXPECT_NE(message(100000, 3).find("vertices that a file of this size may"), std::string::npos);
  EXPECT_NE(message(3, 100000).find("corners that a file of this size may"), std::string::npos);
  EXPECT_EQ(message(3, 3), "no error");
  EXPECT_EQ(message(15000, 3, 150), "no error") << "two million vertices are few for any file";
}

TEST(WriteGlb, ComesBack) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "a.glb";
  TriangleMesh mesh = test::torus(30, 20);
  VertexPaint paint;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    paint.colours.push_back({static_cast<std::uint8_t>(i), 7, 200, static_cast<std::uint8_t>(i / 2)});
    paint.masks.push_back(static_cast<float>(i % 5) / 4);
  }
  write_mesh(path, mesh, paint);
  const PolygonMesh back = read_mesh(path);
  EXPECT_EQ(back.positions, mesh.positions);
  EXPECT_EQ(triangulate(back).triangles, mesh.triangles);
  EXPECT_EQ(back.paint.colours, paint.colours);
  EXPECT_EQ(back.paint.masks, paint.masks);

  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    mesh.triangle_uv.push_back({Vec2f(0, 0.25F), Vec2f(static_cast<float>(i), 0), Vec2f(1, 1)});
  write_mesh(path, mesh, {}, Vec3d(448256, 5411840, 0.5));
  const PolygonMesh split = read_mesh(path);
  EXPECT_GT(split.positions.size(), mesh.positions.size());
  ASSERT_EQ(split.face_vertices.size(), 3 * mesh.triangles.size());
  for (std::size_t i = 0; i < split.face_vertices.size(); ++i) {
    const Vec3d place = split.positions[split.face_vertices[i]].cast<double>() + split.origin;
    const Vec3d expected =
        mesh.positions[mesh.triangles[i / 3][i % 3]].cast<double>() + Vec3d(448256, 5411840, 0.5);
    ASSERT_LT((place - expected).norm(), 1e-6);
    ASSERT_EQ(split.corner_uv[i], mesh.triangle_uv[i / 3][i % 3]);
  }
}

TEST(WriteGlb, IsCutOffNowhereUnseen) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "a.glb";
  write_mesh(path, test::torus(4, 3));
  const std::string bytes = read_file(path);
  for (std::size_t size = 1; size < bytes.size(); size += 13) {
    write_file_whole(path, [&](std::ostream& out) { out << bytes.substr(0, size); });
    EXPECT_THROW(read_mesh(path), FileError) << size;
  }
}

}  // namespace
}  // namespace burin
