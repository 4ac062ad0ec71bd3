#!/usr/bin/env bash
# OpenImageIO 2.4.7.1 (Debian 12): read_image of a TIFF file of 64-bit floating-point numbers in tiles, or in a single
# row, returns true and gives zeros; of 24-bit whole numbers in strips it gives other numbers. geterror() is empty.
#
# Writes four files of 16 columns whose every value is half of the greatest (doubles: 0.5) by libtiff: doubles in a strip
# of 16 rows, which is read right, doubles in a tile, doubles in one row, and 24-bit numbers; reads them and prints the
# first value of each. Exit code 0: as told above; 1: other.
set -euo pipefail
version=2.4.7.1+dfsg-2
if [ "$(dpkg-query -W -f '${Version}' libopenimageio-dev 2>/dev/null)" != "$version" ]; then
  apt-get install -q -y --no-install-recommends "libopenimageio-dev=$version" libtiff-dev g++ >/dev/null
fi
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
cat >"$work/read.cpp" <<'CPP'
#include <OpenImageIO/imageio.h>
#include <cstdio>
#include <string>
#include <tiffio.h>
#include <vector>

float first_of(const std::string& path, int rows, int bits, bool tiled, std::vector<unsigned char> texels) {
  TIFF* tiff = TIFFOpen(path.c_str(), "w");
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, 16);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, rows);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, bits);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
  TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, bits == 64 ? SAMPLEFORMAT_IEEEFP : SAMPLEFORMAT_UINT);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  if (tiled) {
    TIFFSetField(tiff, TIFFTAG_TILEWIDTH, 16);
    TIFFSetField(tiff, TIFFTAG_TILELENGTH, 16);
    TIFFWriteEncodedTile(tiff, 0, texels.data(), static_cast<tmsize_t>(texels.size()));
  } else {
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, rows);
    TIFFWriteEncodedStrip(tiff, 0, texels.data(), static_cast<tmsize_t>(texels.size()));
  }
  TIFFClose(tiff);
  auto in = OIIO::ImageInput::open(path);
  std::vector<float> values(16 * rows, -1);
  const bool read = in->read_image(0, 0, 0, 1, OIIO::TypeFloat, values.data());
  std::printf("%s: read_image %s, error '%s', first value %g\n", path.c_str() + path.rfind('/') + 1,
              read ? "true" : "false", in->geterror().c_str(), values[0]);
  return values[0];
}

std::vector<unsigned char> repeated(const void* value, std::size_t size, int count) {
  std::vector<unsigned char> bytes;
  for (int i = 0; i < count; ++i)
    bytes.insert(bytes.end(), static_cast<const unsigned char*>(value), static_cast<const unsigned char*>(value) + size);
  return bytes;
}

int main(int, char** arguments) {
  const std::string folder = arguments[1];
  const double half = 0.5;
  const unsigned char middle[] = {0, 0, 0x80};  // 0x800000 in little endian
  const float strip = first_of(folder + "/strip.tif", 16, 64, false, repeated(&half, 8, 256));
  const float tile = first_of(folder + "/tile.tif", 16, 64, true, repeated(&half, 8, 256));
  const float row = first_of(folder + "/row.tif", 1, 64, false, repeated(&half, 8, 16));
  const float words = first_of(folder + "/24.tif", 16, 24, false, repeated(middle, 3, 256));
  return strip == 0.5F && tile == 0 && row == 0 && !(words > 0.49F && words < 0.51F) ? 0 : 1;
}
CPP
g++ -std=c++17 -w "$work/read.cpp" -o "$work/read" -lOpenImageIO -lOpenImageIO_Util -ltiff
"$work/read" "$work"
