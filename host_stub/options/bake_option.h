#pragma once
#include <burin/base/vector.h>
#include <burin/deform/bake.h>

#include <span>
#include <string>

#include "cli_fwd.h"
#include "system/console.h"

namespace burin {

/// The displacement map to write, from the command line.
struct BakeOptions {
  std::string path;  ///< empty for none
  BakeSettings settings;

  bool asked() const { return !path.empty(); }
};

/// Adds --bake, --bake-size and --bake-vectors.
void add_bake_options(CLI::App& command, BakeOptions& options);

/// Throws FileError if the map cannot be created, so that a bad path fails before the work starts.
void check_bake_path(const BakeOptions& options);

/// Bakes and writes the map, and warns of its defects. Returns a JSON description of the map. Throws
/// FileError.
Json write_map(const BakeOptions& options, TriangleMesh base, std::span<const Vec3f> displaced);

}  // namespace burin
