#pragma once
#include <burin/host/session.h>

#include <span>
#include <string>

#include "system/console.h"

namespace burin {

/// What strokes did that merged solids with the surface, by the names of MergeReport.
Json merges_json(std::span<const MergeReport> merges);
std::string merges_text(std::span<const MergeReport> merges);

}  // namespace burin
