#include <burin/stamp/files/stamp_file.h>
#include <burin/stamp/float_image.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "support/shared_data.h"

namespace burin {
namespace {

bool is_loaded(const std::string& library) {
  std::ostringstream maps;
  maps << std::ifstream("/proc/self/maps").rdbuf();
  return maps.str().find(library) != std::string::npos;
}

TEST(LoadedCodec, LoadsOpenImageIoWithTheFirstImageOnly) {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "a.exr";
  EXPECT_FALSE(is_loaded("libOpenImageIO"));
  write_exr(path, {2, 1, {"Y"}, {0.25f, -3}});
  EXPECT_TRUE(is_loaded("burin-images.so"));
  EXPECT_TRUE(is_loaded("libOpenImageIO"));
  EXPECT_EQ(read_stamp(path).texels, (std::vector<float>{0.25f, -3}));
}

}  // namespace
}  // namespace burin
