#!/usr/bin/env bash
# OpenImageIO 2.4.7.1 (Debian 12) takes a TIFF file without the tag BitsPerSample for one of 8 bits and gives wrong texels
# without a word. The tag's default is 1 (TIFF 6.0), and files of black and white may leave it out.
#
# Writes a TIFF of 16 x 4 bits, every second column white, without the tag; reads it and prints the second texel, 1, and
# what came. Exit code 0: as told above; 1: other.
set -euo pipefail
version=2.4.7.1+dfsg-2
if [ "$(dpkg-query -W -f '${Version}' libopenimageio-dev 2>/dev/null)" != "$version" ]; then
  apt-get install -q -y --no-install-recommends "libopenimageio-dev=$version" g++ >/dev/null
fi
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
cat >"$work/bits.cpp" <<'CPP'
#include <OpenImageIO/imageio.h>
#include <cstdint>
#include <cstdio>
#include <vector>

int main(int, char** arguments) {
  const std::uint32_t tags[][2] = {{256, 16}, {257, 4}, {259, 1}, {262, 1}, {273, 110}, {277, 1}, {278, 4}, {279, 8}};
  std::FILE* file = std::fopen(arguments[1], "wb");
  const auto put = [file](std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) std::fputc(static_cast<int>(value >> 8 * i & 255), file);
  };
  std::fwrite("II*\0", 1, 4, file);
  put(8, 4);
  put(8, 2);
  for (const auto& tag : tags) put(tag[0], 2), put(4, 2), put(1, 4), put(tag[1], 4);
  put(0, 4);
  for (int i = 0; i < 8; ++i) put(0x55, 1);
  std::fclose(file);

  auto in = OIIO::ImageInput::open(arguments[1]);
  std::vector<float> values(64, -1);
  const bool read = in && in->read_image(0, 0, 0, 1, OIIO::TypeFloat, values.data());
  const int bits = read ? in->spec().get_int_attribute("oiio:BitsPerSample", 8) : 0;
  std::printf("OpenImageIO %s: %d bits, texel 1 is %g instead of 1\n", OIIO_VERSION_STRING, bits, values[1]);
  return read && bits == 8 && values[1] != 1 ? 0 : 1;
}
CPP
g++ -std=c++17 -I/usr/include/Imath "$work/bits.cpp" -o "$work/bits" -lOpenImageIO -lOpenImageIO_Util
"$work/bits" "$work/bits.tif"
