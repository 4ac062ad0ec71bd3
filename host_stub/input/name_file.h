#pragma once
#include <burin/base/error.h>

#include <string_view>

namespace burin {

/// What `work()` returns; an error that does not name a file yet is said of the file at `path`.
template <class Work>
auto naming_file(std::string_view path, const Work& work) {
  try {
    return work();
  } catch (const FileError&) {
    throw;
  } catch (const Error& error) {
    throw FileError(path, error.what());
  }
}

}  // namespace burin
