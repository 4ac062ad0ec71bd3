// The image codec of programs that load OpenImageIO when they open an image.
#include <burin/base/error.h>
#include <burin/image_module/image_module.h>
#include <burin/version.h>
#include <dlfcn.h>

#include <filesystem>
#include <string>

namespace burin {
namespace {

namespace fs = std::filesystem;

/// The module lies beside the program, as in a build tree, or in lib/burin beside the program's folder.
fs::path module_file() {
  const fs::path folder = fs::read_symlink("/proc/self/exe").parent_path();
  fs::path beside = folder / "burin-images.so";
  return fs::exists(beside) ? beside : folder.parent_path() / "lib" / "burin" / "burin-images.so";
}

/// The module stays loaded until the process ends, since libraries that it loads do not expect to be
/// unloaded.
const ImageCodec& loaded_codec() {
  const std::string file = module_file().string();
  void* module = dlopen(file.c_str(), RTLD_LAZY | RTLD_LOCAL);
  if (!module) throw Error(file + ": cannot be loaded to read or write an image: " + dlerror());
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
