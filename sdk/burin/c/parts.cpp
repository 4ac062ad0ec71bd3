// What strokes made beside the surface, for C.
#include <burin/c/triangles.h>
#include <burin/host/c/call.h>
#include <burin/host/c/handles.h>
#include <burin/solid_module/loaded_solids.h>

#include <memory>
#include <string>
#include <utility>

namespace burin::c {
namespace {

/// Moves a mesh from the world to the caller's object.
void place(TriangleMesh& mesh, const Placement& placement) {
  for (Vec3f& position : mesh.positions) position = placement.to_object(position);
  if (placement.mirrors()) turn_over(mesh.triangles);
}

/// Gives a mesh to the caller; `make` makes it of the part that has this number.
template <class Parts, class Make>
burin_status give_part(const burin_session* session, Parts (Session::*parts)() const, std::uint64_t number,
                       const Make& make, burin_triangles** triangles, burin_text* error) {
  return in_session(session, error, [&] {
    require(triangles, "triangles");
    const auto all = (session->session.*parts)();
    if (number >= all.size())
      throw plugin::Error("there are " + std::to_string(all.size()) + " of them", BURIN_NOT_FOUND);
    auto made = std::make_unique<burin_triangles>(make(all[number]));
    if (session->object) place(made->mesh, session->object->placement());
    *triangles = made.release();
  });
}

}  // namespace
}  // namespace burin::c

using namespace burin;

burin_status burin_session_read_solid(const burin_session* session, uint64_t solid,
                                      burin_triangles** triangles, burin_text* error) {
  const auto make = [](const StrokeSolid& of) {
    return burin_triangles{solid_tools().mesh_of(TaskRunner::current(), of)};
  };
  return c::give_part(session, &Session::parts, solid, make, triangles, error);
}

burin_status burin_session_read_bent_mesh(const burin_session* session, uint64_t mesh,
                                          burin_triangles** triangles, burin_text* error) {
  const auto make = [](const TriangleMesh& of) { return burin_triangles{of}; };
  return c::give_part(session, &Session::bent_meshes, mesh, make, triangles, error);
}
