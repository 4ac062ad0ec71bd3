// Gives programs that load OpenImageIO when they open an image their image codec.
#include <burin/base/error.h>
#include <burin/base/program_file.h>
#include <burin/image_module/image_module.h>
#include <burin/version.h>
#include <dlfcn.h>

#include <string>

namespace burin {
namespace {

/// The module stays loaded until the process ends, since libraries that it loads do not expect to be
/// unloaded.
const ImageCodec& loaded_codec() {
  const std::string file = beside_own_file("burin-images.so").string();
  void* module = dlopen(file.c_str(), RTLD_LAZY | RTLD_LOCAL);
  if (!module) throw FileError(file, std::string("cannot be loaded to read or write an image: ") + dlerror());
  const auto entry = reinterpret_cast<decltype(&burin_image_codec)>(dlsym(module, "burin_image_codec"));
  const ImageCodec* codec = entry ? entry(BURIN_VERSION) : nullptr;
  if (!codec) throw FileError(file, "belongs to another version of burin");
  return *codec;
}

}  // namespace

const ImageCodec& image_codec() {
  static const ImageCodec& codec = loaded_codec();
  return codec;
}

}  // namespace burin
