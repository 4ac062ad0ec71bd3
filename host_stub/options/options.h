#pragma once
#include <burin/base/text/number_text.h>
#include <burin/base/vector.h>
#include <burin/stroke/param_setting.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli_fwd.h"

namespace burin {

/// Accepts finite numbers above zero.
const CLI::Validator& positive_number();

/// Accepts finite numbers.
const CLI::Validator& finite_number();

/// Accepts finite numbers from zero on.
const CLI::Validator& number_from_0();

/// Accepts whole numbers from zero on.
const CLI::Validator& whole_number_from_0();

/// Accepts whole numbers from one on.
const CLI::Validator& whole_number_from_1();

/// Lets an option take one of these words, in whatever case; the help names them. Returns the option.
CLI::Option* choose(CLI::Option* option, const std::vector<std::string>& words);

/// Adds an option that takes "x,y,z", finite and not all zero.
void add_vector_option(CLI::App& command, const std::string& name, std::optional<Vec3d>& vector,
                       const std::string& help);

/// The value of "NAME=VALUE": true and false, a number, numbers between commas, else text; always text where
/// `is_text` says so of the NAME. Throws CLI::ValidationError without a NAME.
ParamSettings parse_param_settings(const std::vector<std::string>& texts,
                                   const std::function<bool(const std::string& name)>& is_text);

}  // namespace burin
