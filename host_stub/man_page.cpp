// Writes the manual page from the options of the command line.
#include "man_page.h"

#include <burin/version.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cctype>

namespace burin {
namespace {

/// Text as roff takes it: hyphens that may be copied, no line that begins as a request.
std::string roff(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '-') {
      escaped += "\\-";
    } else if (c == '\\') {
      escaped += "\\e";
    } else if ((c == '.' || c == '\'') && (escaped.empty() || escaped.back() == '\n')) {
      escaped += std::string("\\&") + c;
    } else {
      escaped += c;
    }
  }
  return escaped;
}

/// A sentence: help texts have neither capital nor full stop.
std::string sentence(std::string text) {
  if (text.empty()) return text;
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return roff(text + ".");
}

/// "[OPTIONS] FILE" as the usage of a subcommand shows it.
std::string usage(const CLI::App& command) {
  std::string text = "[OPTION...]";
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_positional()) continue;
    const std::string name = option->get_name(true);
    text += option->get_required() ? " " + name : " [" + name + "]";
  }
  return text;
}

/// "INT in [0 - 15]" of CLI11's "INT:INT in [0 - 15]".
std::string type_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::size_t colon = type.find(':');
  if (colon == type.npos || colon == 0 || type[colon - 1] == '[') return type;
  const std::string name = type.substr(0, colon), values = type.substr(colon + 1);
  return values.starts_with('{') || values.starts_with(name) ? values : name;
}

std::string paragraph(const CLI::Option& option) {
  std::string names = fmt::format(
      "\\fB{}\\fR", roff(option.get_positional() ? option.get_name(true) : option.get_name(false, true)));
  if (const std::string type = type_of(option); !option.get_positional() && !type.empty())
    names += fmt::format(" \\fI{}\\fR", roff(type));
  return fmt::format(".TP\n{}\n{}\n", names, sentence(option.get_description()));
}

std::string section(const CLI::App& command) {
  std::string text = fmt::format(".SS burin {} {}\n{}\n", roff(command.get_name()), roff(usage(command)),
                                 sentence(command.get_description()));
  for (const CLI::Option* option : command.get_options())
    if (option->get_name() != "--help" && !option->get_group().empty()) text += paragraph(*option);
  return text;
}

}  // namespace

std::string man_page(const CLI::App& app) {
  std::string text = fmt::format(
      ".TH BURIN 1 \"\" \"Burin {}\" \"User commands\"\n.SH NAME\nburin \\- draws recorded pen strokes on "
      "surfaces with brush plugins\n.SH SYNOPSIS\n.B burin\n.I COMMAND\n[OPTION...]\n.SH DESCRIPTION\n"
      "Results go to the standard output, messages to the standard error.\n"
      "Each command has \\fB\\-\\-help\\fR.\n.SH COMMANDS\n",
      BURIN_VERSION);
  for (const CLI::App* command : app.get_subcommands({}))
    if (!command->get_group().empty()) text += section(*command);
  return text +
         ".SH ENVIRONMENT\n.TP\n\\fBBURIN_PLUGIN_PATH\\fR\nFolders with brushes, NAME.burin, between "
         "colons.\n"
         ".SH EXIT STATUS\n0 for success, 1 for a test that failed or a fault of the machine, 2 for bad "
         "input or "
         "usage.\n";
}

}  // namespace burin
