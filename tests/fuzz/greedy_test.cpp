// Tests small files that announce billions of elements.

#include <burin/base/file.h>
#include <gtest/gtest.h>

#include "peak_memory.h"
#include "readers.h"
#include "support/shared_data.h"

namespace burin::fuzz {
namespace {

struct Greedy {
  const char* reader;
  std::string bytes;
};

const std::string ply_vertices = "property float x\nproperty float y\nproperty float z\n";

const Greedy greedy_files[] = {
    {"ply", "ply\nformat binary_little_endian 1.0\nelement vertex 4294967295\n" + ply_vertices +
                "element face 4294967295\nproperty list uint int vertex_indices\nend_header\n"},
    {"ply", "ply\nformat ascii 1.0\nelement vertex 3\n" + ply_vertices +
                "element face 1\nproperty list uint int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 "
                "0\n4294967295 0\n"},
    {"ply",
     "ply\nformat ascii 1.0\nelement nothing 4000000000\nelement vertex 0\n" + ply_vertices + "end_header\n"},
    {"stl", std::string(80, ' ') + "\xff\xff\xff\xff" + std::string(50, '\0')},
    {"off", "OFF\n4294967295 4294967295 4294967295\n0 0 0\n4294967295 0 1 2\n"},
    {"obj", "v 0 0 0\nf 4294967295 1 -2147483648\n"},
    {"obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nt crease 2147483647/2147483647/2147483647 0 1 2\n"},
    {"gltf",
     R"({"asset":{"version":"2.0"},"accessors":[{"componentType":5126,"type":"VEC3","count":4000000000}],)"
     R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}]})"},
    {"glb", std::string("glTF\2\0\0\0\xff\xff\xff\xff\xff\xff\xff\xffJSON", 20)},
    {"svc", "1000000000\n1 1 0 1 0 900 1\n"},
    {"uim", std::string("RIFF\x0c\0\0\0UINKINPT\xff\xff\xff\xff\x0a\xff\xff\xff\xff\x0f", 26)},
    {"will", std::string("RIFF\x0c\0\0\0WILLINK \x05\0\0\0\xff\xff\xff\xff\x0f\0", 26)},
    {"tilt", std::string("\xcd\xa5\x76\xc5\5\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80", 20)},
    {"isf", std::string("\0\x0c\x0a\x0a\xff\xff\xff\xff\x07\x87\x87\0\0\0", 14)},
    {"remarkable", "reMarkable .lines file, version=5          \xff\xff\xff\x7f"},
    {"remarkable", "reMarkable .lines file, version=6          \xff\xff\xff\xff"},
    {"scap", "#1 1\n@1\n{\nnan 1 0\n"},
    {"pointer", R"({"x":[1e308],"y":[1],"time":[0],"pointerId":[4294967295]})"},
};

TEST(GreedyFiles, AreRefusedWithoutMuchMemory) {
  const test::TemporaryFolder folder;
  const double before = peak_memory();
  for (const Greedy& file : greedy_files) {
    const Reader& reader = *reader_named(file.reader);
    const auto path = folder.path() / ("greedy" + std::string(reader.extension));
    write_file_whole(path, [&](std::ostream& out) { out << file.bytes; });
    EXPECT_FALSE(accepts(reader, path)) << file.bytes;
  }
  EXPECT_LT(peak_memory() - before, 50e6);
}

}  // namespace
}  // namespace burin::fuzz
