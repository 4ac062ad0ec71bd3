// Gives programs that link OpenImageIO their image codec. Nothing else is in this source, so that programs
// with another definition of image_codec() do not get this one from the library.
#include <burin/image_codec/open_image_io_codec.h>

namespace burin {

const ImageCodec& image_codec() { return open_image_io_codec(); }

}  // namespace burin
