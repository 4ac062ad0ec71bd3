#include <burin/base/error.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "command.h"
#include "console.h"

namespace {

/// 2: bad input or usage; 1: a fault of the machine or of Burin.
int fail(int code, const char* what) {
  std::fputs(fmt::format("burin: {}\n", what).c_str(), stderr);
  return code;
}

int run(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
    if (app.get_subcommands().empty()) return fail(2, "a subcommand is required: burin --help lists them");
    if (!burin::flush_results()) return fail(2, "standard output: writing failed");
    return 0;
  } catch (const CLI::ParseError& error) {
    return error.get_exit_code() == 0 ? app.exit(error) : fail(2, error.what());
  } catch (const burin::Error& error) {
    return fail(2, error.what());
  } catch (const std::bad_alloc&) {
    return fail(1, "out of memory");
  } catch (const std::exception& error) {
    return fail(1, error.what());
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Burin draws recorded pen strokes on surfaces with brush plugins.", "burin");
  // Not required of CLI11, which would then not name an unknown one.
  app.require_subcommand(0, 1);
  burin::command::add_replay(app);
  burin::command::add_chart(app);
  burin::command::add_render(app);
  burin::command::add_list(app);
  burin::command::add_stamp(app);
  burin::command::add_import(app);
  burin::command::add_bench(app);
  return run(app, argc, argv);
}
