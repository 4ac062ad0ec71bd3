#pragma once
#include <burin/stamp/files/picture.h>

#include <filesystem>
#include <string>
#include <vector>

#include "host_stub/bench/plot.h"

namespace burin::paper {

/// One HTML page that needs nothing besides itself. Texts are escaped.
class Page {
 public:
  explicit Page(const std::string& title);

  void heading(const std::string& text);
  void paragraph(const std::string& text);
  void table(const std::vector<std::string>& head, const std::vector<std::vector<std::string>>& rows);

  struct Captioned {
    Picture picture;
    std::string caption;
  };
  /// Side by side.
  void pictures(const std::vector<Captioned>& row);

  void plot(const Plot& plot);

  /// Whole or not at all. Throws FileError.
  void write(const std::filesystem::path& path) const;

 private:
  std::string body_;
};

}  // namespace burin::paper
