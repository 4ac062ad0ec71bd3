#include <OpenImageIO/imageio.h>
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/stamp/float_image.h>
#include <gtest/gtest.h>

#include "support/shared_data.h"

namespace burin {
namespace {

FloatImage waves(int width, int height, std::vector<std::string> channels) {
  FloatImage image{width, height, std::move(channels), {}};
  for (std::size_t i = 0; i < image.channels.size() * static_cast<std::size_t>(width * height); ++i)
    image.texels.push_back(1e-3F * static_cast<float>(i) * (i % 2 == 0 ? 1.0F : -1e5F));
  return image;
}

TEST(WriteExr, IsReadBackBitForBit) {
  test::TemporaryFolder folder;
  for (const auto& channels : {std::vector<std::string>{"Y"}, {"R", "G", "B"}}) {
    const auto path = folder.path() / "a map.exr";
    const FloatImage image = waves(37, 23, channels);
    write_exr(path, image);
    const auto input = OIIO::ImageInput::open(path.string());
    ASSERT_TRUE(input) << OIIO::geterror();
    EXPECT_STREQ(input->format_name(), "openexr");
    EXPECT_EQ(input->spec().width, 37);
    EXPECT_EQ(input->spec().height, 23);
    EXPECT_EQ(input->spec().channelnames, channels);
    EXPECT_EQ(input->spec().format, OIIO::TypeFloat);
    EXPECT_EQ(input->spec().get_string_attribute("DateTime"), "");
    std::vector<float> read(image.texels.size());
    ASSERT_TRUE(input->read_image(0, 0, 0, input->spec().nchannels, OIIO::TypeFloat, read.data()));
    EXPECT_EQ(read, image.texels);
  }
}

TEST(WriteExr, IsTheSameEveryTime) {
  test::TemporaryFolder folder;
  write_exr(folder.path() / "a.exr", waves(300, 200, {"Y"}));
  write_exr(folder.path() / "b.exr", waves(300, 200, {"Y"}));
  EXPECT_EQ(read_file(folder.path() / "a.exr"), read_file(folder.path() / "b.exr"));
}

TEST(WriteExr, LeavesNothingBehindWhereItFails) {
  test::TemporaryFolder folder;
  EXPECT_THROW(write_exr(folder.path() / "none" / "a.exr", waves(4, 4, {"Y"})), FileError);
  EXPECT_THROW(write_exr(folder.path() / "a.exr", FloatImage{}), ContractError);
  EXPECT_THROW(write_exr(folder.path() / "a.exr", FloatImage{-2, -2, {"Y"}, std::vector<float>(4)}),
               ContractError);
  EXPECT_THROW(write_exr(folder.path() / "a.exr", FloatImage{2, 2, {"Y"}, std::vector<float>(5)}),
               ContractError);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace burin
