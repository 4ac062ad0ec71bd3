#pragma once
#include <burin/host/session.h>

#include <span>
#include <string>

#include "system/console.h"

namespace burin {

/// What strokes did that merged solids with the surface, by the names of MergeReport.
Json merges_json(std::span<const MergeReport> merges);
std::string merges_text(std::span<const MergeReport> merges);

/// What strokes refined, by the names of RefineReport.
Json refinements_json(std::span<const RefineReport> refinements);
std::string refinements_text(std::span<const RefineReport> refinements);

}  // namespace burin
