#pragma once
#include <burin/ink/pen_file.h>

#include <string>

#include "system/console.h"

namespace burin::command {

/// What the samples of a pen file are like, as an object and in some lines for people.
Json facts_json(const std::string& path, const PenFile& file);
std::string facts_text(const std::string& path, const PenFile& file);

}  // namespace burin::command
