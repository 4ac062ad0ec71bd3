#pragma once
#include <burin/base/vector.h>
#include <burin/chart/joins/joins.h>
#include <burin/stroke/curve/surface_curve.h>
#include <burin/stroke/recording.h>
#include <burin/stroke/stabiliser.h>

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

/// Adds an option that takes "x,y,z", finite and not all zero.
void add_vector_option(CLI::App& command, const std::string& name, std::optional<Vec3d>& vector,
                       const std::string& help);

/// The same for a place, which may be the origin; it stays as it is where none is given.
void add_point_option(CLI::App& command, const std::string& name, Vec3d& point, const std::string& help);

/// Adds --dynamic and --stabilise.
void add_input_options(CLI::App& command, std::vector<Dynamic>& dynamics, Stabilising& stabilising);

/// Adds --closed, --pressure-width and --join.
void add_stroke_options(CLI::App& command, std::optional<Closure>& closure, double& pressure_width,
                        Join& join);

/// Adds --follow.
void add_follow_option(CLI::App& command, std::optional<double>& follow);

/// The value of "NAME=VALUE": true and false, a number, numbers between commas, else text; always text where
/// `is_text` says so of the NAME. Throws CLI::ValidationError without a NAME.
ParamSettings parse_param_settings(const std::vector<std::string>& texts,
                                   const std::function<bool(const std::string& name)>& is_text);

}  // namespace burin
