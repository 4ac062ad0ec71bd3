#pragma once
#include <burin/base/error.h>

#include <string_view>

namespace burin {

/// Returns the result of work(). An Error from it that is not a FileError is rethrown as a FileError for
/// `path`.
template <class Work>
auto with_file_context(std::string_view path, const Work& work) {
  try {
    return work();
  } catch (const FileError&) {
    throw;
  } catch (const Error& error) {
    throw FileError(path, error.what());
  }
}

}  // namespace burin
