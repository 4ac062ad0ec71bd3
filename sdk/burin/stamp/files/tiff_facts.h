#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>

namespace burin {

/// What a TIFF file says of its first image that is not read with its texels.
struct TiffFacts {
  bool white_is_zero = false;     ///< 0 stands for white: PhotometricInterpretation 0
  bool numbers = true;            ///< grey or colours, not a colour space of another kind (CIE Lab, CMYK)
  std::optional<double> no_data;  ///< the value of texels that hold nothing, as GDAL writes it
  bool cut_off = false;           ///< texels of the first image lie beyond the end of the file
  bool more_images = false;       ///< besides masks and smaller copies of the first
};

/// Throws FileError when the file is not readable as a TIFF.
TiffFacts read_tiff_facts(const std::filesystem::path& path, std::uintmax_t file_bytes);

}  // namespace burin
