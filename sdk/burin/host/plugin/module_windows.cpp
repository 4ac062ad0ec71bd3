// Loads plugin modules with LoadLibraryExW().
#if defined(_WIN32)
#include <burin/base/error.h>
#include <burin/host/plugin/module.h>
#include <windows.h>

#include <system_error>

namespace burin {

Module::Module(const std::filesystem::path& path, const std::filesystem::path& shown) {
  const std::filesystem::path file = std::filesystem::absolute(path);
  handle_ = LoadLibraryExW(file.c_str(), nullptr, LOAD_WITH_ALTERED_SEARCH_PATH);
  if (!handle_) {
    const std::error_code error(static_cast<int>(GetLastError()), std::system_category());
    throw FileError(shown.string(), error.message());
  }
}

Module::~Module() { FreeLibrary(static_cast<HMODULE>(handle_)); }

const void* Module::symbol(const char* name) const {
  return reinterpret_cast<const void*>(GetProcAddress(static_cast<HMODULE>(handle_), name));
}

}  // namespace burin
#endif
