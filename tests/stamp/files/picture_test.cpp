#include <OpenImageIO/imageio.h>
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/stamp/files/picture.h>
#include <gtest/gtest.h>

#include "support/shared_data.h"

namespace burin {
namespace {

Picture gradient(int width, int height) {
  Picture picture{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (const int value : {x * 7, y * 5, x * y}) picture.rgb.push_back(static_cast<std::uint8_t>(value));
  return picture;
}

TEST(WritePng, IsReadBackByteForByte) {
  test::TemporaryFolder folder;
  const auto path = folder.path() / "a picture.png";
  const Picture picture = gradient(37, 23);
  write_png(path, picture);
  const auto input = OIIO::ImageInput::open(path.string());
  ASSERT_TRUE(input) << OIIO::geterror();
  EXPECT_STREQ(input->format_name(), "png");
  EXPECT_EQ(input->spec().width, 37);
  EXPECT_EQ(input->spec().height, 23);
  ASSERT_EQ(input->spec().nchannels, 3);
  EXPECT_EQ(input->spec().format, OIIO::TypeUInt8);
  std::vector<std::uint8_t> read(picture.rgb.size());
  ASSERT_TRUE(input->read_image(0, 0, 0, 3, OIIO::TypeUInt8, read.data()));
  EXPECT_EQ(read, picture.rgb);
}

TEST(WritePng, IsTheSameEveryTime) {
  test::TemporaryFolder folder;
  write_png(folder.path() / "a.png", gradient(300, 200));
  write_png(folder.path() / "b.png", gradient(300, 200));
  EXPECT_EQ(read_file(folder.path() / "a.png"), read_file(folder.path() / "b.png"));
}

TEST(WritePng, LeavesNothingBehindWhereItFails) {
  test::TemporaryFolder folder;
  const auto taken = folder.path() / "taken";
  std::filesystem::create_directories(taken / "inside");
  EXPECT_THROW(write_png(taken, gradient(4, 4)), FileError);
  EXPECT_THROW(write_png(folder.path() / "none" / "a.png", gradient(4, 4)), FileError);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(WritePng, RefusesPicturesOfTheWrongSize) {
  test::TemporaryFolder folder;
  const auto path = folder.path() / "a.png";
  EXPECT_THROW(write_png(path, Picture{}), ContractError);
  EXPECT_THROW(write_png(path, Picture{-2, -2, std::vector<std::uint8_t>(12)}), ContractError);
  EXPECT_THROW(write_png(path, Picture{2, 2, std::vector<std::uint8_t>(11)}), ContractError);
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace burin
