#pragma once
#include <cstdio>
#include <memory>
#include <string>

namespace burin {

/// A temporary file without a name that receives the output of a program. Unlike a pipe it never fills up, so
/// it need not be read while the program runs.
class CaptureFile {
 public:
  /// Throws Error if the file cannot be created.
  CaptureFile();

  std::FILE* stream() const { return stream_.get(); }

  /// The whole content.
  std::string text() const;

 private:
  struct Close {
    void operator()(std::FILE* stream) const { std::fclose(stream); }
  };
  std::unique_ptr<std::FILE, Close> stream_;
};

}  // namespace burin
