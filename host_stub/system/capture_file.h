#pragma once
#include <cstdio>
#include <memory>
#include <string>

namespace burin {

/// A nameless file that takes what a program writes, as pipes fill up and would have to be read in turn.
class CaptureFile {
 public:
  /// Throws Error when the system gives none.
  CaptureFile();

  std::FILE* stream() const { return stream_.get(); }

  /// All of it, from its beginning.
  std::string text() const;

 private:
  struct Close {
    void operator()(std::FILE* stream) const { std::fclose(stream); }
  };
  std::unique_ptr<std::FILE, Close> stream_;
};

}  // namespace burin
