// Loads plugin modules with dlopen().
#if !defined(_WIN32)
#include <burin/base/error.h>
#include <burin/host/plugin/module.h>
#include <burin/host/plugin/module_file.h>
#include <dlfcn.h>

#include <string>
#include <string_view>

namespace burin {
namespace {

/// The text of dlerror() without the path that it usually starts with, since the error message has the path
/// already.
std::string load_error(const std::string& path) {
  const char* text = dlerror();
  std::string_view reason = text ? text : "cannot be loaded";
  if (reason.starts_with(path + ": ")) reason.remove_prefix(path.size() + 2);
  return std::string(reason);
}

}  // namespace

Module::Module(const std::filesystem::path& path, const std::filesystem::path& shown) {
  // The path must be absolute: dlopen() searches a bare name among the system's libraries.
  const std::string file = std::filesystem::absolute(path).string();
  // dlopen() counts on whole files.
  if (is_cut_off(file)) throw FileError(shown.string(), "is cut off: it ends before what its header names");
  handle_ = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle_) throw FileError(shown.string(), load_error(file));
}

Module::~Module() { dlclose(handle_); }

const void* Module::symbol(const char* name) const { return dlsym(handle_, name); }

}  // namespace burin
#endif
