#pragma once
#include <burin/stroke/given_settings.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli_fwd.h"

namespace burin {

/// Adds the options of these settings of the table, which put into `given` what the command line has. The
/// help says of recorded settings that they are `absent` unless given.
void add_setting_options(CLI::App& command, GivenSettings& given, std::span<const std::string_view> keys,
                         std::string_view absent = "as recorded");

/// The same for all settings but `params`, whose types the brush decides: --param has its texts.
void add_all_setting_options(CLI::App& command, GivenSettings& given, std::vector<std::string>& params);

}  // namespace burin
