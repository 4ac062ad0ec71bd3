#pragma once
#include <burin/remesh/patch_mesh.h>

namespace burin {

/// Removes closed pieces of a patch that hang together with nothing else and hold less than this volume,
/// cubic object units; hollows as well. Pieces with fixed vertices or with a border stay.
void remove_specks(PatchMesh& patch, double volume);

}  // namespace burin
