#!/usr/bin/env bash
# OpenImageIO 2.4.7.1 (Debian 12): read_image of a TIFF file whose only strip cannot be decoded, since it is damaged or
# compressed in a way that libtiff was built without, returns true and gives zeros; geterror() is empty.
#
# Writes a TIFF of 16 x 16 bytes compressed by deflate, damages the middle of its strip, reads it and prints what it
# got. Exit code 0: as told above; 1: other.
set -euo pipefail
version=2.4.7.1+dfsg-2
if [ "$(dpkg-query -W -f '${Version}' libopenimageio-dev 2>/dev/null)" != "$version" ]; then
  apt-get install -q -y --no-install-recommends "libopenimageio-dev=$version" libtiff-dev g++ >/dev/null
fi
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
cat >"$work/strip.cpp" <<'CPP'
#include <OpenImageIO/imageio.h>
#include <cstdio>
#include <tiffio.h>
#include <vector>

int main(int, char** arguments) {
  unsigned char texels[256];
  for (int i = 0; i < 256; ++i) texels[i] = static_cast<unsigned char>(i * i | 1);
  TIFF* tiff = TIFFOpen(arguments[1], "w");
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, 16);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, 16);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, 16);
  TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
  TIFFWriteEncodedStrip(tiff, 0, texels, 256);
  TIFFClose(tiff);
  std::FILE* file = std::fopen(arguments[1], "r+b");
  std::fseek(file, 20, SEEK_SET);
  for (int i = 0; i < 30; ++i) std::fputc(0x5a, file);
  std::fclose(file);

  auto in = OIIO::ImageInput::open(arguments[1]);
  std::vector<float> values(256, -1);
  const bool read = in->read_image(0, 0, 0, 1, OIIO::TypeFloat, values.data());
  std::printf("OpenImageIO %s: read_image %s, last value %g, error '%s'\n", OIIO_VERSION_STRING,
              read ? "true" : "false", values[255], in->geterror().c_str());
  return read && values[255] == 0 ? 0 : 1;
}
CPP
g++ -std=c++17 -I/usr/include/Imath "$work/strip.cpp" -o "$work/strip" -lOpenImageIO -lOpenImageIO_Util -ltiff
"$work/strip" "$work/strip.tif"
