// Opens each image once with its mip pyramid; a HandleStore counts who uses it.
#include <burin/services/stamp_store.h>

#include <system_error>
#include <utility>

namespace burin {

StampStore::Opened StampStore::open(const std::filesystem::path& path, const StampOptions& options) {
  std::error_code unknown;  // ignored, since read_stamp() reports what is wrong with the path
  Opened opened;
  opened.handle = stamps_.open({std::filesystem::weakly_canonical(path, unknown), options}, [&] {
    StampFile file;
    MipPyramid pyramid = make_mip_pyramid(read_stamp(path, options, &file));
    opened.filled = file.not_finite;
    return pyramid;
  });
  return opened;
}

std::uint64_t StampStore::add(StampImage image) { return stamps_.add(make_mip_pyramid(std::move(image))); }

}  // namespace burin
