// Reads PNG files with libpng directly, so that no colour conversion is applied.
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/base/text/quoted_word.h>
#include <burin/stamp/files/image_limits.h>
#include <burin/stamp/files/png_reader.h>
#include <burin/stamp/orientation.h>
#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <string_view>

namespace burin {
namespace {

/// Reads one file with libpng. The library reports errors by longjmp, which must not skip destructors of
/// local objects. So all objects with destructors are members.
class PngReader {
 public:
  PngReader(std::string path, std::string bytes)
      : path_(std::move(path)), bytes_(std::move(bytes)), rest_(bytes_) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, fail, ignore);
    info_ = png_ ? png_create_info_struct(png_) : nullptr;
    if (!info_) throw FileError(path_, "out of memory");
    png_set_read_fn(png_, this, read);
  }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }

  PngImage numbers() {
    expect(read_header());
    image_.width = png_get_image_width(png_, info_);
    image_.height = png_get_image_height(png_, info_);
    const bool palette = png_get_color_type(png_, info_) == PNG_COLOR_TYPE_PALETTE;
    check_stamp_size(path_, image_.width, image_.height, palette ? 3 : png_get_channels(png_, info_),
                     bytes_.size());
    expect(set_layout());
    image_.channels = png_get_channels(png_, info_);
    image_.words = png_get_bit_depth(png_, info_) == 16;
    row_bytes_ = png_get_rowbytes(png_, info_);
    raw_.resize(row_bytes_ * image_.height);
    for (std::size_t y = 0; y < image_.height; ++y) rows_.push_back(raw_.data() + y * row_bytes_);
    expect(read_rows());
    set_texels();
    return std::move(image_);
  }

 private:
  // A longjmp returns to one of the next three functions, which have no local objects with destructors.
  bool read_header() {
    if (setjmp(png_jmpbuf(png_))) return false;
    png_read_info(png_, info_);
    return true;
  }

  bool set_layout() {
    if (setjmp(png_jmpbuf(png_))) return false;
    png_set_palette_to_rgb(png_);
    png_set_expand_gray_1_2_4_to_8(png_);
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    return true;
  }

  bool read_rows() {
    if (setjmp(png_jmpbuf(png_))) return false;
    png_read_image(png_, rows_.data());
    png_read_end(png_, info_);
    png_bytep exif = nullptr;
    png_uint_32 size = 0;
    if (png_get_eXIf_1(png_, info_, &size, &exif))
      image_.orientation = exif_orientation({reinterpret_cast<const char*>(exif), size});
    return true;
  }

  void expect(bool read) const {
    if (!read) throw FileError(path_, "is damaged: " + error_);
  }

  void set_texels() {
    const std::size_t values = std::size_t{image_.width} * image_.height * image_.channels;
    image_.texels.reserve(values);
    const float unit = 1 / (image_.words ? 65535.0f : 255.0f);  // OpenImageIO's factor for other formats
    for (std::size_t i = 0; i < values; ++i) {
      const unsigned number = image_.words ? unsigned{raw_[2 * i]} << 8 | raw_[2 * i + 1] : raw_[i];
      image_.texels.push_back(static_cast<float>(number) * unit);
    }
  }

  [[noreturn]] static void fail(png_structp png, png_const_charp what) {
    static_cast<PngReader*>(png_get_error_ptr(png))->error_ = printable(what);
    png_longjmp(png, 1);
  }
  static void ignore(png_structp, png_const_charp) {}

  static void read(png_structp png, png_bytep to, std::size_t size) {
    std::string_view& rest = static_cast<PngReader*>(png_get_io_ptr(png))->rest_;
    if (size > rest.size()) png_error(png, "it ends too early");
    std::copy_n(rest.begin(), size, to);
    rest.remove_prefix(size);
  }

  const std::string path_, bytes_;
  std::string_view rest_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  std::string error_;
  std::size_t row_bytes_ = 0;
  std::vector<png_byte> raw_;
  std::vector<png_bytep> rows_;
  PngImage image_;
};

}  // namespace

PngImage read_png_numbers(const std::filesystem::path& path) {
  return PngReader(path.string(), read_file(path)).numbers();
}

}  // namespace burin
