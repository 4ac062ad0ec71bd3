#include <OpenImageIO/deepdata.h>
#include <OpenImageIO/imageio.h>
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/stamp/files/stamp_file.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <random>

#include "support/shared_data.h"

namespace burin {
namespace {

namespace fs = std::filesystem;

/// The error message of read_stamp() for the file, without the path; "accepted" if there is none.
std::string complaint(const fs::path& path) {
  try {
    read_stamp(path);
  } catch (const FileError& error) {
    const std::string what = error.what();
    EXPECT_EQ(what.rfind(path.string() + ":", 0), 0u) << what;
    EXPECT_EQ(what.find('\n'), what.npos) << what;
    return what.substr(path.string().size() + 1);
  }
  return "accepted";
}

struct RealStamp {
  const char* name;
  int size, channels;
  float minimum, maximum;
};

TEST(ReadStamp, ReadsRealStamps) {
  for (const RealStamp& expected : {
           RealStamp{"Leather031_height_1024_half_zip.exr", 1024, 1, 0, 0.961914f},
           RealStamp{"PavingStones098_height_1024_half_piz.exr", 1024, 1, 0.020584f, 1},
           RealStamp{"Rock035_height_1024_half_zip.exr", 1024, 1, 0, 1},
           RealStamp{"Sponge001_height_512_float_zips.exr", 512, 1, 0.007843f, 0.943382f},
           RealStamp{"oexr_GrayRampsDiagonal.exr", 800, 1, 0.0018f, 18},
           RealStamp{"oexr_PeriodicPattern.exr", 517, 3, 0.049988f, 1},
           RealStamp{"t3d_acrylic1.exr", 100, 3, 0, 0.941406f},
           RealStamp{"t3d_hill1.exr", 256, 4, 0, 1.005781f},
           RealStamp{"t3d_mountain1.exr", 256, 1, 0, 1.004875f},
           RealStamp{"t3d_ring1.exr", 100, 4, 0, 1},
           RealStamp{"t3d_square5.exr", 100, 4, 0.000007f, 1},
           RealStamp{"t3d_stones.exr", 512, 3, 0, 1},
           RealStamp{"t3d_terrain3.exr", 512, 4, 0.001679f, 0.997559f},
           RealStamp{"t3d_texture1.exr", 100, 3, 0, 0.937012f},
           RealStamp{"vdm_spot_head_256_float_zip.exr", 256, 3, -0.539463f, 0.490770f},
           RealStamp{"vdm_spot_horn_128_half_zip.exr", 128, 3, -0.652344f, 0.5625f},
       }) {
    SCOPED_TRACE(expected.name);
    BURIN_SHARED_DATA_OR_SKIP(path, std::string("stamps/") + expected.name);
    const StampImage image = read_stamp(path);
    EXPECT_EQ(image.width, expected.size);
    EXPECT_EQ(image.height, expected.size);
    EXPECT_EQ(image.channels, expected.channels);
    EXPECT_EQ(image.texels.size(),
              static_cast<std::size_t>(expected.size * expected.size * expected.channels));
    EXPECT_NEAR(image.minimum, expected.minimum, 1e-6);
    EXPECT_NEAR(image.maximum, expected.maximum, 1e-6);
  }
}

TEST(ReadStamp, KeepsTheBorderOfZeros) {
  BURIN_SHARED_DATA_OR_SKIP(path, "stamps/vdm_spot_head_256_float_zip.exr");
  const StampImage image = read_stamp(path);
  for (int i = 0; i < 256; ++i)
    for (const int border : {i, 255 * 256 + i, 256 * i, 256 * i + 255})
      for (int c = 0; c < 3; ++c) ASSERT_EQ(image.texels[static_cast<std::size_t>(3 * border + c)], 0);
}

TEST(ReadStamp, RefusesARealImageWithTexelsThatAreNotFinite) {
  BURIN_SHARED_DATA_OR_SKIP(path, "stamps/oexr_BrightRingsNanInf.exr");
  EXPECT_EQ(complaint(path), "channel R, x 320, y 320: the texel is not finite (nan)");
}

class WrittenStamp : public ::testing::Test {
 protected:
  /// Writes the values, row by row, as the spec says.
  template <class Value>
  fs::path write(const OIIO::ImageSpec& spec, const std::vector<Value>& values, const char* name = "a.exr") {
    const fs::path path = folder_.path() / name;
    const auto output = OIIO::ImageOutput::create(path.string());
    EXPECT_TRUE(output && output->open(path.string(), spec)) << OIIO::geterror();
    EXPECT_TRUE(output->write_image(OIIO::BaseTypeFromC<Value>::value, values.data())) << output->geterror();
    output->close();
    return path;
  }

  test::TemporaryFolder folder_;
};

OIIO::ImageSpec float_spec(int width, int height, int channels) {
  return {width, height, channels, OIIO::TypeFloat};
}

TEST_F(WrittenStamp, NamesTheTexelThatIsNotFinite) {
  std::vector<float> values(5 * 4 * 3, 0.5f);
  values[(2 * 5 + 3) * 3 + 1] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(complaint(write(float_spec(5, 4, 3), values)),
            "channel G, x 3, y 2: the texel is not finite (nan)");
  values[(2 * 5 + 3) * 3 + 1] = -std::numeric_limits<float>::infinity();
  EXPECT_EQ(complaint(write(float_spec(5, 4, 3), values)),
            "channel G, x 3, y 2: the texel is not finite (-inf)");
}

TEST_F(WrittenStamp, TakesTheDisplayWindowAndFillsWithZero) {
  OIIO::ImageSpec spec = float_spec(3, 3, 1);
  spec.x = -1;
  spec.y = 2;
  spec.full_x = 0;
  spec.full_y = 1;
  spec.full_width = 4;
  spec.full_height = 3;
  std::vector<float> values = {1, 2, 3, 4, 5, 6, 7, 8, 9};
  values[0] = std::numeric_limits<float>::quiet_NaN();  // outside the display window
  StampFile file;
  const StampImage image = read_stamp(write(spec, values), {}, &file);
  EXPECT_EQ(image.width, 4);
  EXPECT_EQ(image.height, 3);
  EXPECT_EQ(image.texels, (std::vector<float>{0, 0, 0, 0,  //
                                              2, 3, 0, 0,  //
                                              5, 6, 0, 0}));
  EXPECT_EQ(image.minimum, 0);
  EXPECT_EQ(image.maximum, 6);
  EXPECT_EQ(file.data_x, -1);
  EXPECT_EQ(file.data_y, 1);
  EXPECT_EQ(file.data_width, 3);
  EXPECT_EQ(file.data_height, 3);
}

TEST_F(WrittenStamp, IsZeroWhereTheWindowsDoNotMeet) {
  OIIO::ImageSpec spec = float_spec(2, 2, 1);
  spec.x = 100;
  spec.y = -50;
  spec.full_width = spec.full_height = 3;
  const StampImage image = read_stamp(write(spec, std::vector<float>(4, 7)));
  EXPECT_EQ(image.texels, std::vector<float>(9, 0));
}

TEST_F(WrittenStamp, ReadsWholeNumbersAsFractions) {
  const std::vector<std::uint16_t> words = {0, 1, 257, 32768, 65534, 65535};
  const std::vector<std::uint8_t> bytes = {0, 1, 2, 128, 254, 255};
  for (const char* extension : {"png", "tif"}) {
    const std::string name = std::string("a.") + extension;
    const StampImage of_words = read_stamp(write({6, 1, 1, OIIO::TypeUInt16}, words, name.c_str()));
    const StampImage of_bytes = read_stamp(write({6, 1, 1, OIIO::TypeUInt8}, bytes, name.c_str()));
    for (std::size_t i = 0; i < 6; ++i) {
      EXPECT_FLOAT_EQ(of_words.texels[i], static_cast<float>(words[i] / 65535.0)) << name << " " << i;
      EXPECT_FLOAT_EQ(of_bytes.texels[i], static_cast<float>(bytes[i] / 255.0)) << name << " " << i;
    }
  }
}

TEST_F(WrittenStamp, LeavesColourAsItIsBesideAlpha) {
  OIIO::ImageSpec spec(1, 1, 4, OIIO::TypeUInt16);
  spec.attribute("oiio:UnassociatedAlpha", 1);
  const std::vector<std::uint16_t> texel = {40000, 20000, 65535, 1000};
  for (const char* name : {"a.png", "a.tif"}) {
    const StampImage image = read_stamp(write(spec, texel, name));
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_EQ(image.texels[i], static_cast<float>(texel[i] / 65535.0)) << name << " " << i;
  }
}

TEST_F(WrittenStamp, ReadsTilesAndTheLargestMipLevel) {
  OIIO::ImageSpec spec = float_spec(32, 32, 1);
  spec.tile_width = spec.tile_height = 16;
  spec.attribute("wrapmodes", "mirror,clamp");
  spec.attribute("textureformat", "Plain Texture");
  std::vector<float> values(32 * 32);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i);
  const fs::path path = folder_.path() / "tiled.exr";
  auto output = OIIO::ImageOutput::create(path.string());
  ASSERT_TRUE(output->open(path.string(), spec));
  ASSERT_TRUE(output->write_image(OIIO::TypeFloat, values.data()));
  spec.width = spec.height = spec.full_width = spec.full_height = 16;
  ASSERT_TRUE(output->open(path.string(), spec, OIIO::ImageOutput::AppendMIPLevel)) << output->geterror();
  ASSERT_TRUE(output->write_image(OIIO::TypeFloat, values.data()));
  output.reset();
  StampFile file;
  const StampImage image = read_stamp(path, {}, &file);
  EXPECT_EQ(image.texels, values);
  EXPECT_EQ(file.tile_width, 16);
  EXPECT_GE(file.mip_levels, 2);
  EXPECT_EQ(file.texel_type, "float");
  EXPECT_EQ(image.wrap_u, Wrap::mirror);
  EXPECT_EQ(image.wrap_v, Wrap::clamp);
}

TEST_F(WrittenStamp, WrapsAsTheOptionsSayElseAsTheFileDoes) {
  OIIO::ImageSpec spec = float_spec(2, 2, 1);
  const std::vector<float> values(4, 7);
  const auto wraps = [&](const char* modes, Wrap u, Wrap v) {
    if (*modes) spec.attribute("wrapmodes", modes);
    const StampImage image = read_stamp(write(spec, values), {.wrap_u = u, .wrap_v = v});
    return std::pair(image.wrap_u, image.wrap_v);
  };
  EXPECT_EQ(wraps("", Wrap::unknown, Wrap::unknown), std::pair(Wrap::periodic, Wrap::periodic));
  EXPECT_EQ(wraps("", Wrap::black, Wrap::unknown), std::pair(Wrap::black, Wrap::periodic));
  EXPECT_EQ(wraps("clamp,black", Wrap::unknown, Wrap::unknown), std::pair(Wrap::clamp, Wrap::black));
  EXPECT_EQ(wraps("clamp,black", Wrap::unknown, Wrap::mirror), std::pair(Wrap::clamp, Wrap::mirror));
  EXPECT_EQ(wraps("mirror", Wrap::unknown, Wrap::unknown), std::pair(Wrap::mirror, Wrap::mirror));
  EXPECT_EQ(wraps("none,such", Wrap::unknown, Wrap::unknown), std::pair(Wrap::periodic, Wrap::periodic));
}

TEST_F(WrittenStamp, RefusesOtherTexels) {
  OIIO::ImageSpec spec(2, 2, 1, OIIO::TypeUInt32);
  const std::string rest = ", which no stamp is made of";
  EXPECT_EQ(complaint(write(spec, std::vector<unsigned>(4, 7))),
            " channel 'Y' holds texels of type uint" + rest);
  spec = {2, 2, 3, OIIO::TypeFloat};
  spec.channelformats = {OIIO::TypeHalf, OIIO::TypeUInt32, OIIO::TypeHalf};
  spec.channelnames = {"R", "G", "B"};
  EXPECT_EQ(complaint(write(spec, std::vector<float>(12, 7))),
            " channel 'G' holds texels of type uint" + rest);
}

TEST_F(WrittenStamp, RefusesOtherFormats) {
  EXPECT_EQ(complaint(write({2, 2, 3, OIIO::TypeUInt8}, std::vector<unsigned char>(12, 7), "a.bmp")),
            " is no EXR, TIFF, PNG or JPEG image");
}

TEST_F(WrittenStamp, RefusesSeveralParts) {
  const std::vector<float> values(4, 7);
  std::vector<OIIO::ImageSpec> parts(2, float_spec(2, 2, 1));
  parts[0].attribute("name", "left");
  parts[1].attribute("name", "right");
  const std::string parts_exr = "parts.exr";
  for (const std::string& name : {parts_exr, std::string("parts.tif")}) {
    const fs::path path = folder_.path() / name;
    const auto output = OIIO::ImageOutput::create(path.string());
    ASSERT_TRUE(output->open(path.string(), 2, parts.data())) << output->geterror();
    ASSERT_TRUE(output->write_image(OIIO::TypeFloat, values.data()));
    ASSERT_TRUE(output->open(path.string(), parts[1], OIIO::ImageOutput::AppendSubimage));
    ASSERT_TRUE(output->write_image(OIIO::TypeFloat, values.data()));
    output->close();
    EXPECT_EQ(complaint(path),
              name == parts_exr
                  ? " holds several layers, of which one must be chosen by its name: 'left', 'right'"
                  : " holds several images; a stamp is one");
  }
}

TEST_F(WrittenStamp, IsCleanedOfTexelsThatAreNotFiniteWhereAsked) {
  std::vector<float> values(5 * 4 * 3, 0.5f);
  values[(2 * 5 + 3) * 3 + 1] = std::numeric_limits<float>::quiet_NaN();
  values[0] = std::numeric_limits<float>::infinity();
  StampFile file;
  const StampImage image = read_stamp(write(float_spec(5, 4, 3), values), {.clean = true}, &file);
  EXPECT_EQ(image.texels, std::vector<float>(5 * 4 * 3, 0.5f));
  EXPECT_EQ(image.maximum, 0.5f);
  EXPECT_EQ(file.not_finite, 2u);
}

TEST_F(WrittenStamp, RefusesDeepTexels) {
  OIIO::ImageSpec spec = float_spec(2, 2, 1);
  spec.deep = true;
  spec.channelnames = {"Z"};
  OIIO::DeepData deep(spec);
  for (int i = 0; i < 4; ++i) deep.set_samples(i, i);
  const fs::path path = folder_.path() / "deep.exr";
  const auto output = OIIO::ImageOutput::create(path.string());
  ASSERT_TRUE(output->open(path.string(), spec) && output->write_deep_image(deep)) << output->geterror();
  output->close();
  EXPECT_EQ(complaint(path), " holds deep texels; a stamp has one value a texel and channel");
}

TEST_F(WrittenStamp, RefusesWhatIsTooLargeBeforeTakingMemory) {
  OIIO::ImageSpec spec = float_spec(2, 2, 1);
  spec.full_width = spec.full_height = 1 << 20;
  EXPECT_EQ(complaint(write(spec, std::vector<float>(4, 7))),
            " is too large: 1048576 x 1048576 texels of 1 channel; a stamp holds at most 2^27 values");
}

TEST_F(WrittenStamp, RefusesEveryTruncation) {
  std::vector<float> values(64 * 64);
  std::mt19937 random(3);
  for (float& value : values) value = static_cast<float>(random() % 1000);
  const std::string whole = read_file(write(float_spec(64, 64, 1), values));
  const fs::path path = folder_.path() / "cut.exr";
  const auto complaint_of = [&](std::size_t size) {
    write_file_whole(path,
                     [&](std::ostream& out) { out.write(whole.data(), static_cast<std::streamsize>(size)); });
    return complaint(path);
  };
  EXPECT_EQ(complaint_of(whole.size()), "accepted");
  EXPECT_EQ(complaint_of(0), " is empty");
  for (std::size_t size = 1; size < whole.size(); size += 97)
    EXPECT_NE(complaint_of(size), "accepted") << size;
  EXPECT_NE(complaint_of(whole.size() - 1), "accepted");
}

TEST_F(WrittenStamp, SaysNothingOnTheTerminal) {
  const fs::path path = folder_.path() / "text.exr";
  write_file_whole(path, [](std::ostream& out) { out << "not an image"; });
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const std::string text = complaint(path), missing = complaint(folder_.path() / "none.exr"),
                    folder = complaint(folder_.path());
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_NE(text, "accepted");
  EXPECT_EQ(missing, " No such file or directory");
  EXPECT_NE(folder, "accepted");
  std::cout << text << "\n" << folder << "\n";
}

}  // namespace
}  // namespace burin
