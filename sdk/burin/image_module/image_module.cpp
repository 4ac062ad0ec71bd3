// Implements the entry point of the module burin-images.so.
#include <burin/image_codec/open_image_io_codec.h>
#include <burin/image_module/image_module.h>
#include <burin/version.h>

#include <string_view>

const burin::ImageCodec* burin_image_codec(const char* version) {
  return std::string_view(version) == BURIN_VERSION ? &burin::open_image_io_codec() : nullptr;
}
