#pragma once
#include <burin/host/session.h>
#include <burin/host/session/open_stroke.h>
#include <burin/host/session/sculpted_surface.h>

#include <tuple>
#include <utility>
#include <vector>

namespace burin {

/// What strokes made of one kind, in their order, and what those made that were undone, the last one first.
template <class Thing>
struct Made {
  std::vector<Thing> there, undone;

  void take(Turn turn) {
    auto [from, to] = turn == Turn::undo ? std::tie(there, undone) : std::tie(undone, there);
    to.push_back(std::move(from.back()));
    from.pop_back();
  }
};

/// What finished strokes of a session made beside moving and painting vertices.
struct StrokeProducts {
  Made<StrokeSolid> parts;
  Made<MergeReport> merges;
  Made<RefineReport> refinements;
  Made<TriangleMesh> bent_meshes;

  /// Adds what a stroke made beside the surface, if anything, and tells its kind.
  MadePart add(OpenStroke& stroke);

  /// Takes what belongs to a step that is undone or made again.
  void take(const UndoStep& step, Turn turn);

  /// What was undone is gone once another stroke is finished.
  void end_redoing();
};

}  // namespace burin
