#pragma once
#include <burin/deform/shown/undo_journal.h>
#include <burin/host/session.h>

#include <span>

namespace burin {

/// Puts the values of an undo step, of vertices of the surface, into a step of an application's. `source`:
/// [vertex] its number in the original mesh.
void release_values(UndoStep step, std::span<const Index> source, StrokeStep& into);

/// The undo step of vertices of the surface, ascending, that holds the values of an application's step.
/// `of_source`: [vertex of the original mesh] its number on the surface. Throws Error for a vertex that is
/// not there.
UndoStep values_for(const StrokeStep& step, std::span<const Index> of_source);

}  // namespace burin
