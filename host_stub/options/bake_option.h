#pragma once
#include <burin/deform/bake.h>

#include <string>

#include "cli_fwd.h"
#include "system/console.h"

namespace burin {

/// A map of the displacement to write, as the command line asks for it.
struct BakeOptions {
  std::string path;  ///< empty for none
  BakeSettings settings;

  bool asked() const { return !path.empty(); }
};

/// Adds --bake, --bake-size and --bake-vectors.
void add_bake_options(CLI::App& command, BakeOptions& options);

/// Throws FileError when the map cannot come into being: said before long work, not after it.
void check_bake_path(const BakeOptions& options);

/// Bakes and writes the map, and warns of what is wrong with it. Returns what it says of it in JSON. Throws
/// FileError.
Json write_map(const BakeOptions& options, TriangleMesh base, std::span<const Vec3f> displaced);

}  // namespace burin
