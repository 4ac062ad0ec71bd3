#include "readers.h"

#include <burin/base/error.h>
#include <burin/ink/pen_file.h>
#include <burin/stamp/files/stamp_file.h>
#include <burin/stroke/stroke_file.h>
#include <burin/subdiv/refine.h>
#include <burin/surface/mesh_file.h>
#include <burin/surface/point_set.h>
#include <burin/surface/topology/defects.h>
#include <burin/surface/weld_mesh.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <tuple>

namespace burin::fuzz {
namespace {

namespace fs = std::filesystem;

/// Loads a mesh as the commands do: with vertices joined, once as it is and once as a cage.
void load_mesh(const fs::path& path) {
  if (holds_points(path)) {
    make_point_surface(read_points(path), default_links);
    return;
  }
  const PolygonMesh apart = read_mesh(path);
  const PolygonMesh mesh = weld(apart, find_welds(apart, rounding_tolerance(apart)));
  TriangleMesh triangles = refine(mesh, natural_scheme(mesh), 0);
  find_defects(triangles);
  make_surface(std::move(triangles));
  refine(mesh, natural_scheme(mesh), 1);
}

void load_stamp(const fs::path& path) {
  read_stamp(path, {.clean = true});
  read_stamp(path);
}

bool same(const PenStroke& a, const PenStroke& b) {
  const auto values = [](const Sample& sample) {
    const Pen& pen = sample.pen;
    return std::tuple(sample.position.x(), sample.position.y(), sample.position.z(), sample.time,
                      pen.pressure, pen.tilt_x, pen.tilt_y, pen.twist, sample.barrel);
  };
  const auto same_sample = [&](const Sample& one, const Sample& other) {
    return values(one) == values(other);
  };
  return a.fields == b.fields && a.has_z == b.has_z && a.drawn_by == b.drawn_by &&
         a.made_pressure == b.made_pressure && a.page == b.page && a.layer == b.layer &&
         a.widths == b.widths && std::ranges::equal(a.samples, b.samples, same_sample);
}

bool same(const PenFile& a, const PenFile& b) {
  return a.device == b.device && a.unit == b.unit && a.millimetres == b.millimetres &&
         a.hovering == b.hovering && a.not_used == b.not_used &&
         std::ranges::equal(a.strokes, b.strokes,
                            [](const PenStroke& one, const PenStroke& other) { return same(one, other); });
}

std::optional<PenFile> read_or_refused(const PenFileText& file, std::string_view kind) {
  try {
    return read_pen_file(file, kind);
  } catch (const FileError&) {
    return std::nullopt;
  }
}

/// Reads a pen file as a whole and in pieces so small that it has many, as long files are read: what it holds
/// must not depend on that. `kind`: as read_pen_file() takes it.
void compare_pieces(const fs::path& path, std::string_view kind) {
  const PenFileText pieces = open_pen_file(path, {.head = 64, .block = 16}), whole = whole_pen_file(path);
  if (pieces.rest_at == 0) return;
  if (kind.empty()) kind = kind_of_pen_file(pieces);
  const std::optional<PenFile> by_pieces = read_or_refused(pieces, kind),
                               expected = read_or_refused(whole, kind);
  if (by_pieces.has_value() != expected.has_value() || (expected && !same(*by_pieces, *expected)))
    throw std::logic_error("a file read in pieces differs from the same read as a whole");
}

/// Of files that their first bytes tell.
constexpr Reader pen_reader(const char* name) {
  return {name, ".pen", [](const fs::path& path) { read_pen_file(path); },
          [](const fs::path& path) { compare_pieces(path, {}); }};
}

constexpr Reader all[] = {
    {"obj", ".obj", load_mesh},
    {"ply", ".ply", load_mesh},
    {"stl", ".stl", load_mesh},
    {"off", ".off", load_mesh},
    {"gltf", ".gltf", load_mesh},
    {"glb", ".glb", load_mesh},
    {"stroke", ".stroke", [](const fs::path& path) { read_strokes(path); }},
    {"pointer", ".json", [](const fs::path& path) { read_pen_file(open_pen_file(path), "pointer"); },
     [](const fs::path& path) { compare_pieces(path, "pointer"); }},
    {"svc", ".svc", [](const fs::path& path) { read_pen_file(open_pen_file(path), "svc"); },
     [](const fs::path& path) { compare_pieces(path, "svc"); }},
    {"mypaint", ".dat", [](const fs::path& path) { read_pen_file(open_pen_file(path), "mypaint"); },
     [](const fs::path& path) { compare_pieces(path, "mypaint"); }},
    pen_reader("uim"),
    pen_reader("will"),
    pen_reader("tilt"),
    pen_reader("isf"),
    pen_reader("remarkable"),
    pen_reader("excalidraw"),
    pen_reader("point_lists"),
    pen_reader("scap"),
    pen_reader("inkml"),
    pen_reader("xournal"),
    pen_reader("svg"),
    pen_reader("evemu"),
    pen_reader("pointers"),
    pen_reader("csv"),
    pen_reader("uim_json"),
    pen_reader("hid"),
    pen_reader("libinput"),
    pen_reader("brush_stroke"),
    {"exr", ".exr", load_stamp},
    {"png", ".png", load_stamp},
    {"tiff", ".tif", load_stamp},
    {"jpeg", ".jpg", load_stamp},
};

}  // namespace

std::span<const Reader> readers() { return all; }

const Reader* reader_named(const std::string& name) {
  const auto found = std::ranges::find(all, name, &Reader::name);
  return found == std::end(all) ? nullptr : found;
}

bool accepts(const Reader& reader, const fs::path& path) {
  try {
    reader.read(path);
  } catch (const Error&) {
    return false;
  }
  return true;
}

bool accepts_however_read(const Reader& reader, const fs::path& path) {
  try {
    if (reader.compare) reader.compare(path);
  } catch (const Error&) {
    // It is refused before it is read.
  }
  return accepts(reader, path);
}

}  // namespace burin::fuzz
