// Implements the codec that is linked to OpenImageIO.
#include <burin/image_codec/exr_writer.h>
#include <burin/image_codec/image_reader.h>
#include <burin/image_codec/open_image_io_codec.h>

namespace burin {

const ImageCodec& open_image_io_codec() {
  static const ImageCodec codec = {read_image, write_exr_file};
  return codec;
}

}  // namespace burin
