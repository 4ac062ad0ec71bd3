// Writes EXR files.
#include <burin/base/error.h>
#include <burin/stamp/files/image_codec.h>
#include <burin/stamp/float_image.h>

#include <algorithm>

namespace burin {

void write_exr(const std::filesystem::path& path, const FloatImage& image) {
  const std::size_t values = static_cast<std::size_t>(std::max(image.width, 0)) *
                             static_cast<std::size_t>(std::max(image.height, 0)) * image.channels.size();
  if (values == 0 || image.texels.size() != values)
    throw ContractError("write_exr: the image has no texels, or another number of values than its size");
  image_codec().write_exr(path, image);
}

}  // namespace burin
