// embed MESH STROKES BRUSHES OUT.ply: draws recorded strokes on a mesh like an application with a pen and a
// renderer, saves the result, prints its hash and undoes the last stroke.
#include <burin/host/session.h>
#include <burin/host/stroke_pieces.h>
#include <burin/stroke/stroke_file.h>
#include <burin/surface/mesh_file.h>
#include <burin/surface/triangulate.h>
#include <burin/surface/weld_mesh.h>

#include <cstdio>
#include <exception>

using namespace burin;

/// The buffers of the renderer, indexed by the vertices of Session::surface().
struct Buffers {
  std::vector<Vec3f> positions, normals;

  void upload(const Session& session, std::span<const Index> changed) {
    for (const Index vertex : changed) {
      positions[vertex] = session.positions()[vertex];
      normals[vertex] = session.normals()[vertex];
    }
  }
};

/// Loads a mesh and joins the vertices along seams, which files have several times.
TriangleMesh load(const char* path) {
  PolygonMesh mesh = read_mesh(path);
  const std::vector<Index> welds = find_welds(mesh, rounding_tolerance(mesh));
  return triangulate(welds.empty() ? mesh : weld(std::move(mesh), welds));
}

void draw(Session& session, Buffers& shown, const RecordedStroke& recorded) {
  // Or by hand: settings.brush = "org.burin.groove", settings.radius = 0.1, settings.params["depth"] = 0.3.
  StrokeSettings settings = recorded.settings.complete();
  settings.fields = recorded.fields;  // what the pen reports; its pressure is refused otherwise
  StrokePieces stroke(session, settings);
  for (const Sample& sample : recorded.samples)
    shown.upload(session, stroke.add(sample.position, sample.time, sample.pen).changed);
  shown.upload(session, stroke.end());
}

/// Saves the vertices in the order of the file; a session has an order of its own.
void save(const char* path, TriangleMesh mesh, const Session& session) {
  for (Index vertex = 0; vertex < session.surface().vertex_count(); ++vertex)
    mesh.positions[session.surface().source_vertex[vertex]] = session.positions()[vertex];
  write_mesh(path, mesh);
}

int main(int argc, char** argv) try {
  if (argc != 5) throw Error("usage: embed MESH STROKES BRUSHES OUT.ply");
  const TriangleMesh mesh = load(argv[1]);
  const Recording recording = read_strokes(argv[2]);
  BrushLibrary brushes(
      [](int, std::string_view line) { std::fprintf(stderr, "%.*s\n", int(line.size()), line.data()); });
  brushes.load_folder(argv[3]);

  Session session(make_surface(mesh), brushes);
  Buffers shown{session.surface().positions, session.surface().normals};
  for (const RecordedStroke& stroke : recording.strokes) draw(session, shown, stroke);
  save(argv[4], mesh, session);
  std::printf("%016llx\n", static_cast<unsigned long long>(session.result_hash()));

  session.undo();
  shown.upload(session, session.changed());
  return shown.positions == session.surface().positions ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "embed: %s\n", error.what());
  return 2;
}
