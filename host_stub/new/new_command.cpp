// The command `burin new`: writes the project of a new brush, into a folder that does not exist yet.
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/base/program_file.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "command.h"
#include "new/starter.h"
#include "system/console.h"

namespace burin::command {
namespace {

namespace fs = std::filesystem;

struct NewOptions {
  std::string folder;
  std::vector<std::string> features;
  bool c = false, cpp = false;
};

void make_folder(const fs::path& folder) {
  std::error_code error;
  if (!fs::exists(folder, error)) check_output(folder);
  if (!fs::create_directory(folder, error))
    throw FileError(folder.string(), error ? error.message() : "exists already");
}

/// Writes all files, or leaves no folder.
void write_project(const fs::path& folder, const std::vector<StarterFile>& files) {
  make_folder(folder);
  try {
    for (const StarterFile& file : files) {
      fs::create_directories((folder / file.path).parent_path());
      write_file_whole(folder / file.path, [&](std::ostream& out) { out << file.text; });
    }
  } catch (...) {
    std::error_code ignored;
    fs::remove_all(folder, ignored);
    throw;
  }
}

void run(const NewOptions& options) {
  fs::path folder = fs::path(options.folder).lexically_normal();
  if (!folder.has_filename()) folder = folder.parent_path();
  const Starter starter{folder.filename().string(),
                        options.c ? StarterLanguage::c : StarterLanguage::cpp,
                        {options.features.begin(), options.features.end()}};
  write_project(folder, starter_files(starter));
  write_result(fmt::format(
      "{0}: a brush in {1}. Next:\n  cd {0}\n  cmake --preset release\n  cmake --build --preset release\n"
      "  burin try build/{2}.burin\n",
      folder.string(), options.c ? "C" : "C++", starter.name));
  const fs::path guide = program_file().parent_path().parent_path() / "share/doc/burin-dev/guide/guide.md";
  if (fs::exists(guide)) write_result(fmt::format("Guide: {}\n", guide.string()));
}

}  // namespace

void add_new(CLI::App& app) {
  const auto options = std::make_shared<NewOptions>();
  CLI::App& command = *app.add_subcommand("new", "write the project of a new brush");
  command
      .add_option("folder", options->folder,
                  "folder to make; its last part is the name of the brush, of a-z, 0-9 and _")
      ->required()
      ->type_name("FOLDER");
  CLI::Option* c = command.add_flag("--c", options->c, "in C");
  command.add_flag("--cpp", options->cpp, "in C++, the default")->excludes(c);
  command
      .add_option("--features", options->features,
                  "what the brush has besides a displacement: tile, paint, volume")
      ->type_name("LIST")
      ->delimiter(',');
  command.callback([options] { run(*options); });
}

}  // namespace burin::command
