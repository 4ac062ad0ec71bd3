#include "mesh_seeds.h"

#include <burin/surface/mesh_file.h>

#include <bit>
#include <cmath>
#include <cstdint>

namespace burin::fuzz {
namespace {

/// A tetrahedron with texture coordinates that disagree at its vertices, painted in part.
struct Painted {
  TriangleMesh mesh{
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}, {}};
  VertexPaint paint{{{255, 0, 9, 255}, {1, 2, 3, 128}, {0, 0, 0, 0}, {7, 200, 3, 5}}, {1, 0.5F, 0, 1}};

  Painted() { mesh.triangle_uv.assign(4, {Vec2f(0, 0), Vec2f(1, 0.25F), Vec2f(0.5F, 1)}); }
};

void put(std::string& bytes, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<char>(value >> shift & 0xff));
}

std::string binary_stl() {
  const Painted painted;
  std::string bytes(80, ' ');
  put(bytes, static_cast<std::uint32_t>(painted.mesh.triangles.size()));
  for (const Triangle& triangle : painted.mesh.triangles) {
    bytes.append(12, '\0');
    for (const Index vertex : triangle)
      for (const float coordinate : painted.mesh.positions[vertex])
        put(bytes, std::bit_cast<std::uint32_t>(coordinate));
    bytes.append(2, '\0');
  }
  return bytes;
}

}  // namespace

Seeds obj_seeds() {
  const std::string cube =
      "v -1 -1 -1\nv 1 -1 -1\nv -1 1 -1\nv 1 1 -1\nv -1 -1 1\nv 1 -1 1\nv -1 1 1\nv 1 1 1\n"
      "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
  return {cube +
              "t crease 4/2/0 0 1 1 3 2.5 10\nt corner 1/1/0 4 3\nt hole 1/0/0 5\n"
              "t interpolateboundary 1/0/0 1\nt creasemethod 0/0/1 chaikin\n",
          "# colours\r\nmtllib a.mtl\no a\ng b c\nv 0 0 0 1 0 .5\nv 1 0 0 .1 .2 .3\nv 1 1 0 0 0 1\rv 0 1 0 1 "
          "1 1\n"
          "vn 0 0 1\nvt 0 0\nvt 1 0\nvt 1 1\nusemtl m\ns off\nf 1/1/1 2/2/1 \\\n 3/3/1 # end\nf -4//1 -2//1 "
          "-1//1\nl 1 2\n",
          "\xef\xbb\xbfv 448262.01 5411932.25 117\nv 448262.51 5411932.25 117\nv 448262.01 5411932.75 117\n"
          "f 1/ 2/ 3/\n"};
}

Seeds ply_seeds() {
  const std::string places = "property float x\nproperty double y\nproperty float z\n";
  return {
      "ply\nformat ascii 1.0\ncomment c\nobj_info o\nelement vertex 4\n" + places +
          "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float s\nproperty float "
          "t\n"
          "element face 2\nproperty uchar flags\nproperty list uchar int vertex_indices\n"
          "property list uchar float texcoord\nelement edge 1\nproperty int vertex1\nproperty int vertex2\n"
          "end_header\n0 0 0 1 2 3 0 0\n1 0 0 4 5 6 1 0\n1 1 0 7 8 9 1 1\n0 1 0 0 0 0 0 1\n"
          "1 3 0 1 2 6 0 0 1 0 1 1\n0 3 0 2 3 6 0 0 1 1 0 1\n0 1\n",
      "ply\nformat ascii 1.0\nelement vertex 4\n" + places +
          "element tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 1 "
          "0\n"
          "6 0 1 2 3 -1 0\n",
      "ply\nformat ascii 1.0\nelement vertex 3\n" + places +
          "property float nx\nproperty float ny\nproperty float nz\nend_header\n0 0 0 0 0 1\n1 0 0 0 0 1\n"
          "0 1 0 0 0 1\n",
      std::string("ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty short x\nproperty short y\n"
                  "property short z\nelement face 1\nproperty list uchar uchar vertex_index\nend_header\n") +
          std::string("\0\0\0\0\0\0\0\1\0\0\0\0\0\0\0\1\0\0\3\0\1\2", 22)};
}

Seeds stl_seeds() {
  return {
      binary_stl(),
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
      "FACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 1 0 0\nVERTEX 1 1 0\nVERTEX 0 1 0\nENDLOOP\nENDFACET\nendsolid "
      "a\n"};
}

Seeds off_seeds() {
  return {"OFF3 2 1 0 0 0 # a\n1 0 0 0 1 0 3 0 1 2 3 2 1 0 .5",
          "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 255 0 0\n3 0 2 3\n",
          "STCNOFF # all\n3 1 0\n0 0 0 0 0 1 1 2 3 255 0 0\n1 0 0 0 0 1 .1 .2 .3 1 1 0\n0 1 0 0 0 1 9 9 9 0 "
          "0 1\n3 0 1 2\n"};
}

Seeds gltf_seeds() {
  // Three floats (0 0 0), (1 0 0), (0 1 0) and three bytes 0 1 2 0.
  const std::string buffer =
      "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAECAA==";
  const std::string views =
      R"("buffers":[{"byteLength":40,"uri":")" + buffer +
      R"("}],"bufferViews":[{"buffer":0,"byteLength":36,"byteStride":12},{"buffer":0,"byteOffset":36,"byteLength":3}],)";
  const std::string asset = R"({"asset":{"version":"2.0"},)";
  return {
      asset + views +
          R"("scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"children":[1],"translation":[1,2,3]},{"mesh":0,)"
          R"("rotation":[0,0,0.6,0.8],"scale":[1,-1,2]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,)"
          R"("COLOR_0":2},"indices":1}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,)"
          R"("type":"VEC3"},{"bufferView":1,"componentType":5121,"count":3,"type":"SCALAR"},{"bufferView":1,)"
          R"("componentType":5121,"count":1,"type":"VEC3","normalized":true}]})",
      asset + views +
          R"("meshes":[{"primitives":[{"mode":5,"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,)"
          R"("componentType":5126,"count":3,"type":"VEC3","sparse":{"count":1,"indices":{"bufferView":1,)"
          R"("componentType":5121},"values":{"bufferView":0}}}]})",
      asset + views +
          R"("nodes":[{"mesh":0,"skin":0},{"translation":[1,2,3]}],"skins":[{"joints":[0,1]}],)"
          R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":0}}]}],"accessors":[)"
          R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},{"componentType":5121,"count":3,)"
          R"("type":"VEC3"},{"componentType":5126,"count":2,"type":"MAT4"}]})"};
}

void write_mesh_seeds(const std::filesystem::path& file) {
  const Painted painted;
  write_mesh(file, painted.mesh, painted.paint);
}

}  // namespace burin::fuzz
