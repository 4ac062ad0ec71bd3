#pragma once
#include <burin/stamp/files/image_codec.h>

// The module burin-images.so: the image codec in a file of its own. OpenImageIO needs some 250 other
// libraries, which take a quarter of a second and 100 MB to load, so that only programs that open an image
// load it.
extern "C" {

/// Returns the codec, or null if the module belongs to another version of Burin than `version`.
__attribute__((visibility("default"))) const burin::ImageCodec* burin_image_codec(const char* version);
}
