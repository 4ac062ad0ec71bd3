// Reads tags of a TIFF file with libtiff.
#include <burin/base/error.h>
#include <burin/image_codec/tiff_facts.h>
#include <tiffio.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace burin {
namespace {

int keep_silent(TIFF*, void*, const char*, const char*, va_list) { return 1; }

struct Close {
  void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
using Tiff = std::unique_ptr<TIFF, Close>;

/// Opens the file without messages of the library on the terminal.
Tiff open(const std::filesystem::path& path) {
  TIFFOpenOptions* options = TIFFOpenOptionsAlloc();
  TIFFOpenOptionsSetErrorHandlerExtR(options, keep_silent, nullptr);
  TIFFOpenOptionsSetWarningHandlerExtR(options, keep_silent, nullptr);
  Tiff tiff(TIFFOpenExt(path.string().c_str(), "r", options));
  TIFFOpenOptionsFree(options);
  if (!tiff) throw FileError(path.string(), "is damaged: its first directory cannot be read");
  return tiff;
}

/// The no-data value, which GDAL writes as text.
std::optional<double> no_data_value(TIFF* tiff) {
  std::uint32_t size = 0;
  const char* text = nullptr;
  if (!TIFFGetField(tiff, TIFFTAG_GDAL_NODATA, &size, &text) || !text) return std::nullopt;
  const std::string_view number(text, size);
  const std::size_t begin = std::min(number.find_first_not_of(' '), number.size());
  double value = 0;
  const auto [end, error] = std::from_chars(text + begin, text + size, value);
  if (error != std::errc()) return std::nullopt;
  return value;
}

/// The number of strips or tiles.
std::uint32_t count_pieces(TIFF* tiff) {
  return TIFFIsTiled(tiff) ? TIFFNumberOfTiles(tiff) : TIFFNumberOfStrips(tiff);
}

/// Throws FileError for a file that has no bytes of texels: its program did not get as far as to write them,
/// or left all of them out, as GDAL does where all values are the same.
void expect_texels_at_all(TIFF* tiff, const std::filesystem::path& path) {
  std::uint64_t bytes = 0;
  for (std::uint32_t i = 0; i < count_pieces(tiff); ++i) bytes += TIFFGetStrileByteCount(tiff, i);
  if (bytes == 0) throw FileError(path.string(), "holds no texels");
}

bool is_cut_off(TIFF* tiff, std::uintmax_t file_bytes) {
  for (std::uint32_t i = 0; i < count_pieces(tiff); ++i) {
    const std::uint64_t begin = TIFFGetStrileOffset(tiff, i), size = TIFFGetStrileByteCount(tiff, i);
    if (begin > file_bytes || size > file_bytes - begin) return true;
  }
  return false;
}

template <class Value>
Value field(TIFF* tiff, std::uint32_t tag, Value value) {
  TIFFGetFieldDefaulted(tiff, tag, &value);
  return value;
}

/// Whether the colours of the palette are bytes by mistake, and would all become black.
bool has_palette_of_bytes(TIFF* tiff, std::uint16_t bits) {
  std::uint16_t *red = nullptr, *green = nullptr, *blue = nullptr;
  if (bits > 8 || !TIFFGetField(tiff, TIFFTAG_COLORMAP, &red, &green, &blue)) return false;
  std::uint16_t greatest = 0;
  for (const std::uint16_t* channel : {red, green, blue})
    greatest = std::max(greatest, *std::max_element(channel, channel + (std::size_t{1} << bits)));
  return greatest > 0 && greatest < 256;
}

/// Whether the file relies on the default of BitsPerSample, 1, which the format allows; OpenImageIO takes 8.
bool bits_are_untold(TIFF* tiff) {
  std::uint16_t bits = 0;
  return TIFFGetField(tiff, TIFFTAG_BITSPERSAMPLE, &bits) == 0;
}

/// What OpenImageIO does not read, or gives wrong numbers for without a word, as for 24 bits, whatever they
/// mean, and for 64 bits unless they lie in strips of several rows, all channels of a texel together. Empty
/// for other texels.
std::string misread_texels(TIFF* tiff, std::uint16_t meaning) {
  const auto bits = field<std::uint16_t>(tiff, TIFFTAG_BITSPERSAMPLE, 1);
  constexpr std::array<std::uint16_t, 11> read = {1, 2, 4, 6, 8, 10, 12, 14, 16, 32, 64};
  if (std::ranges::find(read, bits) == read.end()) return "numbers of " + std::to_string(bits) + " bits";
  const auto format = field<std::uint16_t>(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
  if (format == SAMPLEFORMAT_COMPLEXINT || format == SAMPLEFORMAT_COMPLEXIEEEFP) return "complex numbers";
  if (bits == 64 && format != SAMPLEFORMAT_IEEEFP) return "whole numbers of 64 bits";
  if (bits_are_untold(tiff) &&
      (TIFFIsTiled(tiff) || field<std::uint16_t>(tiff, TIFFTAG_SAMPLESPERPIXEL, 1) != std::uint16_t{1}))
    return "bits in tiles or several channels without the tag BitsPerSample";
  const bool planes = field<std::uint16_t>(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG) !=
                      std::uint16_t{PLANARCONFIG_CONTIG};
  if (bits == 64 && (TIFFIsTiled(tiff) || planes || field<std::uint32_t>(tiff, TIFFTAG_IMAGELENGTH, 1) < 2))
    return "numbers of 64 bits in tiles, planes or a single row";
  if (meaning == PHOTOMETRIC_PALETTE && has_palette_of_bytes(tiff, bits))
    return "a palette of 8-bit instead of 16-bit colours";
  return {};
}

/// Bits of whole numbers that OpenImageIO widens to 8 or 16 bits by repeating the highest ones, which makes a
/// fraction of the largest number a little wrong; 0 for others.
unsigned odd_bits(TIFF* tiff, std::uint16_t meaning) {
  const auto bits = field<std::uint16_t>(tiff, TIFFTAG_BITSPERSAMPLE, 1);
  const bool even = bits >= 16 || (bits & (bits - 1)) == 0;
  return even || meaning == PHOTOMETRIC_PALETTE ? 0 : bits;
}

/// The largest number of the texels; 1 for floating point.
double greatest_number(TIFF* tiff) {
  const auto bits = field<std::uint16_t>(tiff, TIFFTAG_BITSPERSAMPLE, 1);
  const auto format = field<std::uint16_t>(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
  if (format != SAMPLEFORMAT_UINT && format != SAMPLEFORMAT_INT) return 1;
  const int of_size = std::min<int>(bits, 32) - (format == SAMPLEFORMAT_INT ? 1 : 0);
  return static_cast<double>((std::uint64_t{1} << of_size) - 1);
}

bool is_part_of_first(TIFF* tiff) {
  std::uint32_t kind = 0;
  TIFFGetField(tiff, TIFFTAG_SUBFILETYPE, &kind);
  return (kind & (FILETYPE_REDUCEDIMAGE | FILETYPE_MASK)) != 0;
}

/// Decodes one strip or tile. Returns false if that fails. Those without bytes, which GDAL leaves out where
/// all values are the same, count as decoded.
bool decodes(TIFF* tiff, std::uint32_t piece, std::vector<unsigned char>& texels) {
  if (TIFFGetStrileByteCount(tiff, piece) == 0) return true;
  const auto size = static_cast<tmsize_t>(texels.size());
  return (TIFFIsTiled(tiff) ? TIFFReadEncodedTile(tiff, piece, texels.data(), size)
                            : TIFFReadEncodedStrip(tiff, piece, texels.data(), size)) >= 0;
}

}  // namespace

void expect_texels_that_decode(const std::filesystem::path& path) {
  const Tiff tiff = open(path);
  const tmsize_t size = TIFFIsTiled(tiff.get()) ? TIFFTileSize(tiff.get()) : TIFFStripSize(tiff.get());
  std::vector<unsigned char> texels(static_cast<std::size_t>(std::max<tmsize_t>(size, 0)));
  for (std::uint32_t piece = 0; piece < count_pieces(tiff.get()); ++piece)
    if (!decodes(tiff.get(), piece, texels))
      throw FileError(path.string(), "is damaged, or compressed in a way that is not read: strip or tile " +
                                         std::to_string(piece + 1) + " cannot be decoded");
}

std::vector<float> read_bits(const std::filesystem::path& path) {
  const Tiff tiff = open(path);
  const auto width = field<std::uint32_t>(tiff.get(), TIFFTAG_IMAGEWIDTH, 0),
             height = field<std::uint32_t>(tiff.get(), TIFFTAG_IMAGELENGTH, 0);
  std::vector<unsigned char> row(static_cast<std::size_t>(TIFFScanlineSize(tiff.get())));
  std::vector<float> bits;
  for (std::uint32_t y = 0; y < height; ++y) {
    if (TIFFReadScanline(tiff.get(), row.data(), y) < 0)
      throw FileError(path.string(), "is damaged: row " + std::to_string(y + 1) + " cannot be decoded");
    for (std::uint32_t x = 0; x < width; ++x)
      bits.push_back(static_cast<float>(row[x / 8] >> (7 - x % 8) & 1));
  }
  return bits;
}

TiffInfo read_tiff_facts(const std::filesystem::path& path, std::uintmax_t file_bytes) {
  const Tiff tiff = open(path);
  expect_texels_at_all(tiff.get(), path);
  TiffInfo facts;
  std::uint16_t meaning = PHOTOMETRIC_MINISBLACK;
  TIFFGetField(tiff.get(), TIFFTAG_PHOTOMETRIC, &meaning);
  facts.white_is_zero = meaning == PHOTOMETRIC_MINISWHITE;
  facts.odd_bits = odd_bits(tiff.get(), meaning);
  facts.misread = misread_texels(tiff.get(), meaning);
  facts.untold_bits = bits_are_untold(tiff.get());
  facts.numbers = meaning <= PHOTOMETRIC_PALETTE || meaning == PHOTOMETRIC_YCBCR;
  facts.greatest = greatest_number(tiff.get());
  // That of a palette would be the number of a colour.
  if (meaning != PHOTOMETRIC_PALETTE) facts.no_data = no_data_value(tiff.get());
  facts.cut_off = is_cut_off(tiff.get(), file_bytes);
  while (!facts.more_images && TIFFReadDirectory(tiff.get()))
    facts.more_images = !is_part_of_first(tiff.get());
  return facts;
}

}  // namespace burin
