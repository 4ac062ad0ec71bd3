#pragma once
#include "cli_fwd.h"

namespace burin::command {

/// Each function adds one subcommand, which runs while `app` parses the command line. Its errors leave the
/// parser as burin::Error.
void add_replay(CLI::App& app);
void add_chart(CLI::App& app);
void add_render(CLI::App& app);
void add_list(CLI::App& app);
void add_stamp(CLI::App& app);
void add_import(CLI::App& app);
void add_export(CLI::App& app);
void add_new(CLI::App& app);
void add_try(CLI::App& app);
void add_strokes(CLI::App& app);
void add_snap(CLI::App& app);
void add_bench(CLI::App& app);
void add_bench_brush(CLI::App& app);
void add_validate(CLI::App& app);

}  // namespace burin::command
