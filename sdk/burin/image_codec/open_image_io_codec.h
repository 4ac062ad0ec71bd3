#pragma once
#include <burin/stamp/files/image_codec.h>

namespace burin {

/// The codec that is linked to OpenImageIO.
const ImageCodec& open_image_io_codec();

}  // namespace burin
