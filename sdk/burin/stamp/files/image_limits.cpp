// Checks the size of an image against that of its file.
#include <burin/base/error.h>
#include <burin/stamp/files/image_limits.h>
#include <fmt/format.h>

namespace burin {

void check_stamp_size(const std::string& path, std::uint64_t width, std::uint64_t height,
                      std::uint64_t channels, std::uint64_t file_bytes) {
  constexpr double always = 64e6, times_file = 4000;
  const double values =
      static_cast<double>(width) * static_cast<double>(height) * static_cast<double>(channels);
  if (values < 1) throw FileError(path, "holds no texels");
  if (values > static_cast<double>(most_stamp_values))
    throw FileError(path, fmt::format("is too large: {} x {} texels of {} channel{}; a stamp holds at most "
                                      "2^27 values",
                                      width, height, channels, channels == 1 ? "" : "s"));
  const double bytes = values * sizeof(float);
  if (bytes > always && bytes > times_file * static_cast<double>(file_bytes))
    throw FileError(path, fmt::format("asks for {:.0f} MB of memory in {} bytes; a stamp may ask for 64 MB, "
                                      "or 4000 times its size",
                                      bytes / 1e6, file_bytes));
}

}  // namespace burin
