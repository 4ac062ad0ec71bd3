#!/usr/bin/env bash
# OpenImageIO 2.4.7.1 (Debian 12): after a reader has asked whether a part of a multi-part EXR has a second mip
# level, while another part of other channels was the current one, read_image of that part returns true and gives
# zeros.
#
# The usual way to list a file comes upon it: seek through all parts, then count the levels of the first, then
# read it. Seeking to level 0 of the part before counting avoids it.
#
# Writes a file of two parts, reads it both ways and prints what it got. Exit code 0: as told above; 1: other.
set -euo pipefail
version=2.4.7.1+dfsg-2
if [ "$(dpkg-query -W -f '${Version}' libopenimageio-dev 2>/dev/null)" != "$version" ]; then
  apt-get install -q -y --no-install-recommends "libopenimageio-dev=$version" g++ >/dev/null
fi
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
cat >"$work/parts.cpp" <<'CPP'
#include <OpenImageIO/imageio.h>
#include <cstdio>
#include <vector>
using namespace OIIO;

static float first_value(const char* file, bool seek_first) {
  auto in = ImageInput::open(file);
  for (int part = 0; in->seek_subimage(part, 0);) ++part;  // how many parts are there?
  if (seek_first) in->seek_subimage(0, 0);
  int levels = 1;
  while (in->seek_subimage(0, levels)) ++levels;           // how many mip levels has the first?
  float values[3] = {-1, -1, -1};
  const bool read = in->read_image(0, 0, 0, 3, TypeFloat, values);
  const float value = values[0];
  std::printf("%s: read_image %s, value %g, error '%s'\n", seek_first ? "with a seek before" : "plain",
              read ? "true" : "false", value, in->geterror().c_str());
  return read ? value : -1;
}

int main(int, char** arguments) {
  std::vector<ImageSpec> parts = {ImageSpec(1, 1, 3, TypeFloat), ImageSpec(1, 1, 1, TypeFloat)};
  parts[0].attribute("name", "one");
  parts[1].attribute("name", "two");
  const float one[3] = {5, 5, 5}, two = 7;
  auto out = ImageOutput::create(arguments[1]);
  if (!out->open(arguments[1], 2, parts.data()) || !out->write_image(TypeFloat, one) ||
      !out->open(arguments[1], parts[1], ImageOutput::AppendSubimage) || !out->write_image(TypeFloat, &two))
    return 2;
  out->close();
  std::printf("OpenImageIO %s; the first part holds 5\n", OIIO_VERSION_STRING);
  const float plain = first_value(arguments[1], false), careful = first_value(arguments[1], true);
  return plain == 0 && careful == 5 ? 0 : 1;
}
CPP
g++ -std=c++17 -I/usr/include/Imath "$work/parts.cpp" -o "$work/parts" -lOpenImageIO -lOpenImageIO_Util
"$work/parts" "$work/parts.exr"
