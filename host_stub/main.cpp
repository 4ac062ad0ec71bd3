// The command `burin`: runs the subcommand, and converts exceptions to a message on stderr and an exit code.
#include <burin/base/error.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <string>
#include <string_view>

#include "command.h"
#include "man_page.h"
#include "system/console.h"
#include "system/platform.h"

namespace {

constexpr const char* output_failed = "standard output: writing failed";

/// Reports an error and returns the exit code: 2 for bad input or usage, 1 for a fault of the machine or of
/// Burin.
int fail(int code, const char* what) {
  burin::say("", what);
  return code;
}

/// What CLI11 found wrong. Of an option without its value it writes "--fit: 1 required view|mesh missing".
std::string message_of(const CLI::ParseError& error) {
  constexpr std::string_view before = ": 1 required ", behind = " missing";
  const std::string line = error.what();
  const std::size_t at = line.find(before);
  if (at == line.npos || !line.ends_with(behind)) return line;
  std::string value = line.substr(at + before.size());
  value.resize(value.size() - behind.size());
  // "FLOAT:NUMBER > 0" has the type of the variable, too.
  return line.substr(0, at) + " needs a value: " + value.substr(value.find(':') + 1);
}

/// Lets CLI11 print the help; returns the exit code.
int print_help(const CLI::App& app, const CLI::ParseError& error) {
  const int code = app.exit(error);
  std::cout.flush();
  return std::cout ? code : fail(2, output_failed);
}

int run(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
    if (app.get_subcommands().empty()) return fail(2, "a subcommand is required: burin --help lists them");
    if (!burin::flush_results()) return fail(2, output_failed);
    return 0;
  } catch (const CLI::ParseError& error) {
    return error.get_exit_code() == 0 ? print_help(app, error) : fail(2, message_of(error).c_str());
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
  burin::open_standard_streams();
  CLI::App app("Burin draws recorded pen strokes on surfaces with brush plugins.", "burin");
  // If CLI11 required a subcommand, its message would not give the name of an unknown one.
  app.require_subcommand(0, 1);
  burin::command::add_replay(app);
  burin::command::add_chart(app);
  burin::command::add_render(app);
  burin::command::add_list(app);
  burin::command::add_new(app);
  burin::command::add_try(app);
  burin::command::add_stamp(app);
  burin::command::add_import(app);
  burin::command::add_export(app);
  burin::command::add_strokes(app);
  burin::command::add_snap(app);
  burin::command::add_bench(app);
  burin::command::add_bench_brush(app);
  burin::command::add_validate(app);
  // For packages, which have the page it writes.
  app.add_subcommand("man-page", "write the manual page to the standard output")->group("")->callback([&app] {
    burin::write_result(burin::man_page(app));
  });
  return run(app, argc, argv);
}
