// Tests what holds for stamps of every format.
#include <burin/base/file.h>
#include <burin/stamp/files/stamp_file.h>
#include <gtest/gtest.h>

#include "stamp/files/stamp_files.h"

namespace burin::test {
namespace {

using namespace std::string_literals;

using StampFormats = StampFiles;

TEST_F(StampFormats, SaysOneLineOfDamagedFilesAndNothingBesides) {
  const std::string png = read_file(write_png(64, 64, 16, PNG_COLOR_TYPE_GRAY, std::string(8192, 'x')));
  const std::string tiff = read_file(write_tiff(64, 64, 8, std::string(4096, 'x')));
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  for (const std::string& whole : {png, tiff})
    for (std::size_t at = 8; at < std::min<std::size_t>(whole.size(), 200); ++at)
      for (const char c : {'\0', '\x7f', '\xff'}) {
        std::string damaged = whole;
        damaged[at] = c;
        write_file_whole(path("damaged"), [&](std::ostream& out) { out << damaged; });
        complaint(path("damaged"));
        write_file_whole(path("cut"), [&](std::ostream& out) { out << whole.substr(0, at); });
        complaint(path("cut"));
      }
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  std::string broken = png;
  broken[broken.find("IDAT") + 8] ^= 1;
  write_file_whole(path("broken.png"), [&](std::ostream& out) { out << broken; });
  EXPECT_TRUE(complaint(path("broken.png")).starts_with(": is damaged: IDAT: "));
}

TEST_F(StampFormats, RefusesEveryTruncationOfEveryFormat) {
  std::vector<std::uint8_t> values(64 * 64);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<std::uint8_t>(i * i % 251);
  OIIO::ImageSpec spec(64, 64, 1, OIIO::TypeUInt8);
  for (const char* name : {"a.jpg", "a.tif", "a.png"}) {
    write_image(path(name), spec, values);
    const std::string whole = read_file(path(name));
    EXPECT_EQ(complaint(path(name)), "accepted");
    for (std::size_t size = 1; size < whole.size(); size += 1 + whole.size() / 100) {
      write_file_whole(path("cut"), [&](std::ostream& out) { out << whole.substr(0, size); });
      EXPECT_NE(complaint(path("cut")), "accepted") << name << " " << size << " of " << whole.size();
    }
  }
  // The directory of this file precedes the texels.
  const std::string bytes(64, 'x');
  const auto directory_first = [](TIFF* tiff) { TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, 8); };
  const std::string tiff = read_file(write_tiff(8, 8, 8, bytes, directory_first));
  std::string early = "II\x2a\0\x08\0\0\0"s;
  const std::size_t at = static_cast<unsigned char>(tiff[4]) + 256u * static_cast<unsigned char>(tiff[5]);
  early += tiff.substr(at);
  const std::size_t texels = early.size();
  for (std::size_t entry = 10; entry + 12 < early.size(); entry += 12)
    if (early.compare(entry, 2, "\x11\x01") == 0) early[entry + 8] = static_cast<char>(texels);
  ASSERT_LT(texels, 256u);
  for (const std::size_t kept : {64u, 63u, 0u}) {
    write_file_whole(path("early.tif"), [&](std::ostream& out) { out << early << bytes.substr(0, kept); });
    EXPECT_EQ(complaint(path("early.tif")),
              kept == 64 ? "accepted" : ": is cut off: texels lie beyond its end");
  }
}

TEST_F(StampFormats, MovesTheZeroOfAllChannelsButAlpha) {
  write_image(path("rgba.exr"), OIIO::ImageSpec(1, 1, 4, OIIO::TypeFloat),
              std::vector<float>{0.5f, 0.75f, 0, 1});
  const StampImage image = read_stamp(path("rgba.exr"), {.zero = 0.5f});
  expect_near(image.texels, (std::vector<float>{0, 0.25f, -0.5f, 1}));
  EXPECT_EQ(image.maximum, 0);
}

TEST_F(StampFormats, RefusesLargePicturesInSmallFiles) {
  // A header that tells 5000 x 5000 texels before a few bytes of data.
  std::string png = read_file(write_png(1, 1, 8, PNG_COLOR_TYPE_GRAY, "x"));
  const auto set_size = [](std::string& bytes, std::size_t at, std::size_t step, int value) {
    bytes[at] = static_cast<char>(value >> 8);
    bytes[at + step] = static_cast<char>(value & 255);
  };
  OIIO::ImageSpec spec(8, 8, 3, OIIO::TypeUInt8);
  write_image(path("a.jpg"), spec, std::vector<std::uint8_t>(192));
  std::string jpeg = read_file(path("a.jpg"));
  const std::size_t frame = jpeg.find("\xff\xc0");
  ASSERT_NE(frame, jpeg.npos);
  for (const int at : {5, 7}) set_size(jpeg, frame + static_cast<std::size_t>(at), 1, 5000);
  write_file_whole(path("large.jpg"), [&](std::ostream& out) { out << jpeg; });
  EXPECT_EQ(complaint(path("large.jpg")), ": asks for 300 MB of memory in " + std::to_string(jpeg.size()) +
                                              " bytes; a stamp may ask for 64 MB, or 4000 times its size");
  spec = OIIO::ImageSpec(2, 2, 1, OIIO::TypeFloat);
  spec.full_width = spec.full_height = 5000;
  write_image(path("window.exr"), spec, std::vector<float>(4));
  EXPECT_TRUE(complaint(path("window.exr")).starts_with(": asks for 100 MB of memory in "));
  spec.full_width = 12000;
  spec.full_height = 12000;
  write_image(path("window.exr"), spec, std::vector<float>(4));
  EXPECT_EQ(complaint(path("window.exr")),
            ": is too large: 12000 x 12000 texels of 1 channel; a stamp holds at most 2^27 values");
}

TEST_F(StampFormats, TellsTheFormatByTheContentAndRefusesDevices) {
  const fs::path png = write_png(1, 1, 8, PNG_COLOR_TYPE_GRAY, "\x33");
  fs::rename(png, path("a.exr"));
  expect_near(read_stamp(path("a.exr")).texels, std::vector<float>{0.2f});
  if (!fs::exists("/dev/zero")) return;
  EXPECT_EQ(complaint("/dev/zero"), ": is not a file");
}

}  // namespace
}  // namespace burin::test
