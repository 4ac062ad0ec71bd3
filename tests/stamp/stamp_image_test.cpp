#include <OpenImageIO/deepdata.h>
#include <OpenImageIO/imageio.h>
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/stamp/stamp_image.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <random>

#include "support/shared_data.h"

namespace burin {
namespace {

namespace fs = std::filesystem;

/// What read_stamp says of the file, less the path; "accepted" when it reads.
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

/// Mean step across the border in x over mean step within.
double seam(const StampImage& image) {
  const auto at = [&](int x, int y) {
    return image.texels[static_cast<std::size_t>((y * image.width + x) * image.channels)];
  };
  double within = 0, across = 0;
  for (int y = 0; y < image.height; ++y) {
    across += std::abs(at(0, y) - at(image.width - 1, y));
    for (int x = 1; x < image.width; ++x) within += std::abs(at(x, y) - at(x - 1, y));
  }
  return across / (within / (image.width - 1));
}

TEST(ReadStamp, KeepsTheSeamOfATile) {
  BURIN_SHARED_DATA_OR_SKIP(path, "stamps/Rock035_height_1024_half_zip.exr");
  EXPECT_NEAR(seam(read_stamp(path)), 0.91, 0.01);
}

TEST(ReadStamp, KeepsTheSeamOfAnImageThatIsNoTile) {
  BURIN_SHARED_DATA_OR_SKIP(path, "stamps/oexr_GrayRampsDiagonal.exr");
  EXPECT_NEAR(seam(read_stamp(path)), 225, 1);
}

TEST(ReadStamp, KeepsTheBorderOfZeros) {
  BURIN_SHARED_DATA_OR_SKIP(path, "stamps/vdm_spot_head_256_float_zip.exr");
  const StampImage image = read_stamp(path);
  for (int i = 0; i < 256; ++i)
    for (const int border : {i, 255 * 256 + i, 256 * i, 256 * i + 255})
      for (int c = 0; c < 3; ++c) ASSERT_EQ(image.texels[static_cast<std::size_t>(3 * border + c)], 0);
}

TEST(ReadStamp, RefusesARealImageOfWholeNumbers) {
  BURIN_SHARED_DATA_OR_SKIP(path, "stamps/bluenoise_256_HDR_L_0_u16.png");
  EXPECT_EQ(complaint(path),
            " channel Y holds whole numbers (uint16); a stamp is an EXR image of half or float texels");
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
  OIIO::ImageSpec spec = float_spec(3, 3, 2);
  spec.x = -1;
  spec.y = 2;
  spec.full_x = 0;
  spec.full_y = 1;
  spec.full_width = 4;
  spec.full_height = 3;
  std::vector<float> values;
  for (int i = 1; i <= 18; ++i) values.push_back(static_cast<float>(i));
  values[0] = std::numeric_limits<float>::quiet_NaN();  // outside the display window
  const StampImage image = read_stamp(write(spec, values));
  EXPECT_EQ(image.width, 4);
  EXPECT_EQ(image.height, 3);
  EXPECT_EQ(image.texels, (std::vector<float>{0, 0,  0,  0,  0, 0, 0, 0,  //
                                              3, 4,  5,  6,  0, 0, 0, 0,  //
                                              9, 10, 11, 12, 0, 0, 0, 0}));
  EXPECT_EQ(image.minimum, 0);
  EXPECT_EQ(image.maximum, 11);
}

TEST_F(WrittenStamp, IsZeroWhereTheWindowsDoNotMeet) {
  OIIO::ImageSpec spec = float_spec(2, 2, 1);
  spec.x = 100;
  spec.y = -50;
  spec.full_width = spec.full_height = 3;
  const StampImage image = read_stamp(write(spec, std::vector<float>(4, 7)));
  EXPECT_EQ(image.texels, std::vector<float>(9, 0));
}

TEST_F(WrittenStamp, RefusesWholeNumbers) {
  OIIO::ImageSpec spec(2, 2, 1, OIIO::TypeUInt32);
  EXPECT_EQ(complaint(write(spec, std::vector<unsigned>(4, 7))),
            " channel Y holds whole numbers (uint); a stamp is an EXR image of half or float texels");
  spec = {2, 2, 2, OIIO::TypeFloat};
  spec.channelformats = {OIIO::TypeHalf, OIIO::TypeUInt32};
  spec.channelnames = {"Y", "id"};
  EXPECT_EQ(complaint(write(spec, std::vector<float>(8, 7))),
            " channel id holds whole numbers (uint); a stamp is an EXR image of half or float texels");
  spec = {2, 2, 3, OIIO::TypeUInt8};
  EXPECT_EQ(complaint(write(spec, std::vector<unsigned char>(12, 7), "a.jpg")),
            " channel R holds whole numbers (uint8); a stamp is an EXR image of half or float texels");
}

TEST_F(WrittenStamp, RefusesOtherFormatsOfFloats) {
  EXPECT_EQ(complaint(write(float_spec(2, 2, 1), std::vector<float>(4, 7), "a.tif")),
            " is an image of the format tiff, not EXR");
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
            " is too large: a stamp holds at most 2^28 values");
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

StampImage random_image(int width, int height, int channels, std::mt19937& random) {
  StampImage image{width, height, channels, {}, -1, 1};
  std::uniform_real_distribution<float> value(-1, 1);
  for (int i = 0; i < width * height * channels; ++i) image.texels.push_back(value(random));
  return image;
}

/// The sample as a sum over all texels of triangle-shaped weights, repeated with period 1.
double reference(const StampImage& image, int channel, double u, double v) {
  const auto weight = [](double turns, double centre, int size) {
    const double away = turns - centre;
    return std::max(0.0, 1 - std::abs(away - std::round(away)) * size);
  };
  double sum = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      sum += weight(u, (x + 0.5) / image.width, image.width) *
             weight(v, (y + 0.5) / image.height, image.height) *
             double{image.texels[static_cast<std::size_t>((y * image.width + x) * image.channels + channel)]};
  return sum;
}

TEST(SampleBilinear, AgreesWithADoubleReference) {
  const unsigned seed = std::random_device{}();
  std::cout << "seed " << seed << "\n";
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> near(-3, 3), far(-5000, 5000);
  int negative = 0;
  for (const auto& [width, height, channels] :
       {std::array{8, 16, 1}, std::array{7, 5, 3}, std::array{2, 9, 4}, std::array{33, 2, 2}}) {
    const StampImage image = random_image(width, height, channels, random);
    for (int i = 0; i < 5000; ++i) {
      const float u = i % 4 ? near(random) : far(random), v = i % 3 ? near(random) : far(random);
      const int channel = i % channels;
      ASSERT_NEAR(sample_bilinear(image, channel, u, v), reference(image, channel, u, v), 1e-6)
          << u << " " << v;
      negative += u < 0 && v < 0;
    }
  }
  EXPECT_GT(negative, 3000);
}

TEST(SampleBilinear, RepeatsASingleTexel) {
  const StampImage image{1, 1, 2, {3, 4}, 3, 3};
  for (const float u : {-1.0f, -0.3f, 0.0f, 0.5f, 0.9f, 17.0f})
    EXPECT_EQ(sample_bilinear(image, 1, u, -u), 4);
}

TEST(SampleBilinear, IsExactAtTexelCentres) {
  std::mt19937 random(5);
  const StampImage image = random_image(64, 32, 2, random);
  for (const float shift : {0.0f, -1.0f, 1.0f, -700.0f, 4096.0f})
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 64; ++x)
        ASSERT_EQ(sample_bilinear(image, 1, (static_cast<float>(x) + 0.5f) / 64 + shift,
                                  (static_cast<float>(y) + 0.5f) / 32 - shift),
                  image.texels[static_cast<std::size_t>((y * 64 + x) * 2 + 1)]);
}

TEST(SampleBilinear, IsContinuousAcrossTheBorder) {
  std::mt19937 random(6);
  const StampImage image = random_image(13, 21, 1, random);
  for (const float at : {-2.0f, -1.0f, 0.0f, 1.0f, 5.0f})
    for (float other = -1; other < 1; other += 0.013f) {
      const float below = std::nextafter(at, -100.0f), above = std::nextafter(at, 100.0f);
      ASSERT_NEAR(sample_bilinear(image, 0, below, other), sample_bilinear(image, 0, above, other), 1e-4);
      ASSERT_NEAR(sample_bilinear(image, 0, other, below), sample_bilinear(image, 0, other, above), 1e-4);
    }
  EXPECT_EQ(sample_bilinear(image, 0, -1e-30f, 0), sample_bilinear(image, 0, 0, 0));
}

TEST(SampleBilinear, GivesNaNForPlacesThatAreNotFinite) {
  const StampImage image{1, 1, 1, {3}, 3, 3};
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity()}) {
    EXPECT_TRUE(std::isnan(sample_bilinear(image, 0, bad, 0)));
    EXPECT_TRUE(std::isnan(sample_bilinear(image, 0, 0, bad)));
  }
  EXPECT_EQ(sample_bilinear(image, 0, std::numeric_limits<float>::max(), -std::numeric_limits<float>::max()),
            3);
}

}  // namespace
}  // namespace burin
