#pragma once
#include <burin/base/progress.h>
#include <burin/base/task_runner.h>
#include <burin/host/brush_library.h>
#include <burin/host/c/burin.h>
#include <burin/host/c/call.h>
#include <burin/host/c/hidden_faces.h>
#include <burin/host/c/object_space.h>
#include <burin/host/c/pen_input.h>
#include <burin/host/c/shown_values.h>
#include <burin/host/c/told_triangles.h>
#include <burin/host/session.h>

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// What the pointers of C point to.
struct burin_library {
  std::shared_ptr<burin::BrushLibrary> brushes;
  std::shared_ptr<const burin::TaskRunner> threads;  ///< those that the application lends, if any
  burin::SolidMerger merger;                         ///< of solids with surfaces
  std::vector<std::string> refused;                  ///< lines of modules that were passed over
};

namespace burin::c {

/// What C needs to know of the open stroke besides what the session knows.
struct OpenStroke {
  Closure closure;
  std::optional<PenInput> pen;  ///< none: that of the group that draws
  bool piece_begun = false;     ///< the current piece has a sample
  bool whole = true;            ///< no piece has ended yet
};

inline constexpr std::size_t attribute_count = 4;

}  // namespace burin::c

struct burin_session {
  /// `changes`: strokes may change triangles.
  burin_session(const burin_library& library, burin::Surface surface, burin_order numbers, bool changes)
      : brushes(library.brushes),
        threads(library.threads),
        session(std::move(surface), *brushes, changes ? library.merger : burin::SolidMerger()),
        order(session.surface(), numbers),
        vertex_count(session.surface().vertex_count()),
        kept_vertices(vertex_count) {}

  /// Notes vertices of the surface that may have changed.
  void note(std::span<const burin::Index> vertices) {
    for (auto& values : shown)
      if (values) values->note(vertices, order);
  }

  /// The current values of an attribute as the caller has them.
  burin::c::VertexValues values(burin_attribute attribute) const {
    return burin::c::values_of(session, attribute, object ? &*object : nullptr);
  }

  /// Notes what the session's last call changed.
  void note_changed() {
    if (session.generation() != generation) renew();
    note(session.changed());
  }

  /// The triangles that are shown, in the order of the surface, as the caller has them.
  std::vector<burin::Triangle> triangles() const;

  std::shared_ptr<burin::BrushLibrary> brushes;
  std::shared_ptr<const burin::TaskRunner> threads;  ///< of the library
  burin::Session session;
  burin::c::VertexOrder order;
  std::optional<burin::c::ObjectSpace> object;  ///< with a transform
  std::optional<burin::c::HiddenFaces> faces;   ///< if faces may be hidden
  std::optional<burin::c::ToldTriangles> told;  ///< if strokes may split triangles
  burin::Index vertex_count;                    ///< of the surface that is known
  burin::Index kept_vertices;                   ///< that were there all the time since triangles were told
  std::uint64_t generation = 0;                 ///< of the surface that is known
  bool has_other_triangles = false;             ///< than those that were told
  burin::Progress progress;
  std::optional<burin::c::OpenStroke> stroke;
  /// [attribute - 1]; made with its first update
  std::array<std::optional<burin::c::ShownValues>, burin::c::attribute_count> shown;
  std::vector<burin::Index> chart_vertices;  ///< of burin_session_chart
  std::vector<burin_sample> snapped;         ///< of burin_session_snap

 private:
  void renew();
};

namespace burin::c {

/// Runs the body of a call of a session, which must be there, on the threads that its application lends.
template <class Body>
burin_status in_session(const burin_session* session, burin_text* error, const Body& body) {
  return plugin::guarded(error, [&] {
    require(session, "session");
    const TaskRunnerScope scope(session->threads.get());
    body();
  });
}

}  // namespace burin::c
