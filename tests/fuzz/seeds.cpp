#include <burin/base/file.h>
#include <burin/stroke/stroke_file.h>

#include <functional>
#include <map>

#include "image_seeds.h"
#include "mesh_seeds.h"
#include "pen_seeds.h"
#include "readers.h"

namespace burin::fuzz {
namespace {

namespace fs = std::filesystem;

Seeds stroke_seeds() {
  return {
      "{\"burin_stroke\":1,\"space\":\"object\"}\n"
      "{\"begin\":{\"brush\":\"org.burin.groove\",\"radius\":0.2,\"strength\":1,\"follow\":0.5,\"closed\":"
      "true,"
      "\"params\":{\"a\":1,\"b\":true,\"c\":\"text\",\"d\":[0,1,2]},\"dynamics\":[{\"target\":\"radius\","
      "\"source\":\"pressure\",\"curve\":[0,0,1,1]}]},\"fields\":[\"time\",\"x\",\"y\",\"z\",\"pressure\","
      "\"tilt_x\",\"tilt_y\",\"twist\"]}\n[0,0,0,1,0.5,0.1,0.2,3]\n[0.01,0.1,0,1,1,0,0,0]\n{\"end\":true}\n",
      "{\"burin_stroke\":1,\"space\":\"screen\",\"camera\":{\"view\":[1,0,0,0,0,1,0,0,0,0,1,-4,0,0,0,1],"
      "\"projection\":[1,0,0,0,0,1,0,0,0,0,-1,-2,0,0,-1,0],\"viewport\":[640,480]}}\n"
      "{\"begin\":{},\"fields\":[\"x\",\"y\"]}\n[320,240]\n[330,240]\n{\"end\":true}\n"};
}

Seeds pointer_seeds() {
  return {
      R"({"x":[1,2,3,4],"y":[1,2,1,2],"time":[0,8,16,24],"pressure":[0.5,0.6,0.7,0],"buttons":[1,1,1,0],)"
      R"("tiltX":[0,10,20,30],"tiltY":[0,-10,0,0],"twist":[0,90,180,359],"pointerId":[1,1,1,1]})",
      R"({"x":[1,2,3],"y":[1,2,1],"time":[0,8,16]})",
      R"([{"type":"pointerdown","clientX":1,"clientY":2,"pressure":0.5,"timeStamp":8,"pointerId":1,"tiltX":9},)"
      R"({"type":"pointerup","x":3,"y":4,"buttons":0,"pointerType":"pen"}])"};
}

Seeds svc_seeds() {
  return {"3\n10 10 0 1 900 450 0.5\n11 10.5 8 1 900 450 0.6\n12 10 16 0 900 450 0\n",
          "2\r\n1 1 0 1 0 900 1\r\n2 2 1 1 3599 0 1\r\n"};
}

Seeds mypaint_seeds() { return {"0 10 10 0\n0.01 11 10 0.5\n0.02 12 11 0.6\n0.03 13 11 0\n"}; }

const std::map<std::string, std::function<Seeds()>>& texts() {
  static const std::map<std::string, std::function<Seeds()>> all = {
      {"obj", obj_seeds},         {"ply", ply_seeds},   {"stl", stl_seeds},
      {"off", off_seeds},         {"gltf", gltf_seeds}, {"stroke", stroke_seeds},
      {"pointer", pointer_seeds}, {"svc", svc_seeds},   {"mypaint", mypaint_seeds}};
  return all;
}

}  // namespace

std::vector<fs::path> write_seeds(const Reader& reader, const fs::path& folder) {
  const auto found = texts().find(reader.name);
  const std::string extension = reader.extension;
  std::vector<fs::path> files;
  const auto next = [&] {
    return files.emplace_back(folder / ("seed" + std::to_string(files.size()) + extension));
  };
  if (found != texts().end())
    for (const std::string& text : found->second())
      write_file_whole(next(), [&](std::ostream& out) { out << text; });
  for (const PenSeed& seed : pen_seeds())
    if (seed.kind == std::string_view(reader.name))
      write_file_whole(next(), [&](std::ostream& out) { out << seed.bytes; });
  if (extension == ".ply" || extension == ".obj" || extension == ".off" || extension == ".glb")
    write_mesh_seeds(next());
  return files.empty() ? write_image_seeds(extension, folder) : files;
}

}  // namespace burin::fuzz
