// Tests small files that announce billions of elements.

#include <burin/base/file.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>

#include "peak_memory.h"
#include "readers.h"
#include "sanitizers/processor_seconds.h"
#include "sanitizers/sanitized.h"
#include "support/shared_data.h"

namespace burin::fuzz {
namespace {

struct Greedy {
  const char* reader;
  std::string bytes;
};

const std::string ply_vertices = "property float x\nproperty float y\nproperty float z\n";

std::string repeated(std::string_view text, std::size_t times) {
  std::string all;
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

/// SVG whose groups each show the one before twice.
std::string doubled_uses(int groups) {
  std::string text = "<svg><g id=\"g0\"><path d=\"M0 0L1 1\"/></g>";
  for (int i = 0; i < groups; ++i) {
    const std::string use = "<use href=\"#g" + std::to_string(i) + "\"/>";
    text += "<g id=\"g" + std::to_string(i + 1) + "\">" + use + use + "</g>";
  }
  return text + "</svg>";
}

/// SVG that uses an element often.
std::string used(const std::string& element, std::size_t times) {
  return "<svg><defs>" + element + "</defs>" + repeated("<use href=\"#a\"/>", times) + "</svg>";
}

/// SVG whose groups, of many others one within the other, each show the next.
std::string chained_uses(int groups) {
  std::string text = "<svg><defs>";
  for (int i = 0; i < groups; ++i)
    text += "<g id=\"g" + std::to_string(i) + "\">" + repeated("<g>", 190) + "<use href=\"#g" +
            std::to_string(i + 1) + "\"/>" + repeated("</g>", 191);
  return text + "</defs><use href=\"#g0\"/></svg>";
}

/// EVEMU of as many touches at rest as slots, `frames` long, and a line that is none.
std::string resting_touches(int slots, std::size_t frames) {
  std::string text = "# EVEMU 1.3\nA: 2f 0 99999 0 0 0\n";
  for (int i = 0; i < slots; ++i)
    text += "E: 1 3 2f " + std::to_string(i) + "\nE: 1 3 39 1\nE: 1 3 35 1\nE: 1 3 36 1\n";
  return text + repeated("E: 1 0 0 0\n", frames) + "E: x\n";
}

/// hid-recorder's descriptor of a device with as many reports of 32,767 fields each, below 256, and a line
/// that is no report.
std::string reports_of_fields(unsigned reports) {
  std::string bytes = "05 0d 75 01 96 ff 7f";
  for (unsigned i = 1; i <= reports; ++i) {
    constexpr char digits[] = "0123456789abcdef";
    bytes += std::string(" 85 ") + digits[i / 16] + digits[i % 16] + " 09 99 81 02";
  }
  return "R: " + std::to_string((bytes.size() + 1) / 3) + " " + bytes + "\nE: x\n";
}

/// A part of reMarkable's version 6 with its tag.
std::string remarkable_part(char index, const std::string& content) {
  const auto size = static_cast<std::uint32_t>(content.size());
  std::string text(1, static_cast<char>(index << 4 | 12));
  for (int shift = 0; shift < 32; shift += 8) text += static_cast<char>(size >> shift & 0xff);
  return text + content;
}

/// reMarkable's head and as many blocks of text, each of 10 pieces of 10,000 deleted characters, and a byte
/// that begins no block.
std::string deleted_texts(std::size_t blocks) {
  std::string pieces = "\x0a";
  for (char i = 1; i <= 10; ++i)
    pieces += remarkable_part(0, std::string("\x2f\1\x80\x80", 4) + i + std::string("\x54\x10\x27\0\0", 5));
  const std::string text =
      remarkable_part(2, remarkable_part(1, remarkable_part(1, pieces)) +
                             remarkable_part(2, remarkable_part(1, std::string(1, '\0'))));
  const std::string length = remarkable_part(0, text).substr(1, 4);
  return "reMarkable .lines file, version=6          " +
         repeated(length + std::string("\0\1\2\7", 4) + text, blocks) + "x";
}

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
    {"excalidraw", R"({"type":"excalidraw","elements":)" + repeated("[", 3'000'000)},
    {"excalidraw", R"({"type":"excalidraw","elements":[)" + repeated("{\"a\":0},", 1'000'000) + "0]}"},
    {"pointers", "[" + repeated("[],", 2'000'000) + "[]]"},
    {"uim_json", R"({"inputData":{"a":[)" + repeated("0,", 6'000'000) + "0]}}"},
    {"point_lists", R"({"a":[)" + repeated("[1,2],", 900'000) + "[]]}"},
    {"brush_stroke", "f(stroke=[" + repeated("{'mouse':", 200'000)},
    {"inkml", "<ink>" + repeated("<a>", 1'000'000)},
    {"inkml", "<ink>" + repeated("<a>", 300)},
    {"svg", doubled_uses(60)},
    {"svg", chained_uses(100)},
    {"svg", used("<g id=\"a\">" + repeated("<g/>", 4000) + "</g>", 4000)},
    {"svg", used("<path id=\"a\" d=\"" + repeated("M0 0", 20000) + "\"/>", 3000)},
    {"svg", "<svg" + repeated(" a=''", 3'000'000) + ">"},
    {"xournal", "<xournal>" + repeated("<page/>", 1'000'000)},
    {"inkml", "<!DOCTYPE ink [<!ENTITY a \"" + std::string(1000, '1') + "\"><!ENTITY b \"" +
                  repeated("&a;", 1000) + "\">]><ink><trace>&b; 2</trace></ink>"},
    {"csv", "x,y\n1,nan\n"},
    {"csv", "x,y,note\n1,2,\"" + std::string(3'000'000, '\n')},
    {"csv", "x,y\n1," + std::string(3'000'000, '9') + "\n"},
    {"libinput", "libinput:\ndevices: " + repeated("[", 200'000)},
    {"hid", "R: 4000000000 05 0d\n"},
    {"hid", reports_of_fields(40)},
    {"remarkable", deleted_texts(200)},
    {"evemu", resting_touches(64, 30'000)},
    {"evemu", resting_touches(40'000, 30'000)},
    {"pointer", R"({"x":[1e308],"y":[1],"time":[0],"pointerId":[4294967295]})"},
};

struct Refusal {
  bool refused = false;
  double bytes = 0, seconds = 0;
};

/// Reads a file in a child process, whose memory beyond that of its parent is all its own.
Refusal refusal_of(const Reader& reader, const std::filesystem::path& path) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("pipe");
  const pid_t child = fork();
  if (child == 0) {
    const double before = peak_memory();
    Refusal refusal;
    refusal.seconds = test::processor_seconds([&] { refusal.refused = !accepts(reader, path); });
    refusal.bytes = peak_memory() - before;
    _exit(write(ends[1], &refusal, sizeof refusal) == sizeof refusal ? 0 : 1);
  }
  close(ends[1]);
  Refusal refusal;
  EXPECT_EQ(read(ends[0], &refusal, sizeof refusal), static_cast<ssize_t>(sizeof refusal)) << "it crashed";
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return refusal;
}

TEST(GreedyFiles, AreRefusedWithoutMuchMemory) {
  constexpr double most_bytes = 64e6, most_seconds = 2;  // below 1 when nothing else runs
  const test::TemporaryFolder folder;
  for (const Greedy& file : greedy_files) {
    const Reader& reader = *reader_named(file.reader);
    const auto path = folder.path() / ("greedy" + std::string(reader.extension));
    write_file_whole(path, [&](std::ostream& out) { out << file.bytes; });
    const Refusal refusal = refusal_of(reader, path);
    const std::string beginning = file.bytes.substr(0, 60);
    EXPECT_TRUE(refusal.refused) << beginning;
    if (test::sanitized) continue;
    EXPECT_LT(refusal.bytes, most_bytes) << beginning;
    EXPECT_LT(refusal.seconds, most_seconds) << beginning;
  }
}

}  // namespace
}  // namespace burin::fuzz
