#pragma once
#include <string>

#include "cli_fwd.h"

namespace burin {

/// The manual page of the command with all its subcommands, as man(7) has it.
std::string man_page(const CLI::App& app);

}  // namespace burin
