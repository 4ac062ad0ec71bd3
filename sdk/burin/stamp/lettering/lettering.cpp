// Rasterises a shaped line of text with FreeType.
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/stamp/lettering/lettering.h>
#include <burin/stamp/lettering/shaped_line.h>
#include <fmt/format.h>
#include <freetype/freetype.h>
#include <freetype/ftoutln.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <type_traits>

namespace burin {
namespace {

constexpr int margin = 4;  // texels
constexpr std::int64_t most_texels = std::int64_t{1} << 28;

struct Done {
  void operator()(FT_Library library) const { FT_Done_FreeType(library); }
  void operator()(FT_Face face) const { FT_Done_Face(face); }
};
using Library = std::unique_ptr<std::remove_pointer_t<FT_Library>, Done>;
using Face = std::unique_ptr<std::remove_pointer_t<FT_Face>, Done>;

Library open_library() {
  FT_Library library = nullptr;
  if (FT_Init_FreeType(&library) != 0) throw Error("FreeType cannot be started");
  return Library(library);
}

Face open_face(FT_Library library, const std::string& path, std::string_view bytes, std::uint32_t em) {
  FT_Face face = nullptr;
  if (FT_New_Memory_Face(library, reinterpret_cast<const FT_Byte*>(bytes.data()),
                         static_cast<FT_Long>(bytes.size()), 0, &face) != 0)
    throw FileError(path, "is no font");
  Face opened(face);
  if (!FT_IS_SCALABLE(face)) throw FileError(path, "is a font without outlines");
  if (FT_Set_Pixel_Sizes(face, 0, em) != 0) throw FileError(path, "the font cannot be scaled");
  return opened;
}

/// A box in texels: columns to the right from the start of the line, rows upward from the baseline.
struct Box {
  std::int64_t left = std::numeric_limits<std::int64_t>::max(), bottom = left;
  std::int64_t right = std::numeric_limits<std::int64_t>::min(), top = right;
  bool is_empty() const { return left >= right || bottom >= top; }
  void add(const Box& other) {
    if (other.is_empty()) return;
    left = std::min(left, other.left);
    bottom = std::min(bottom, other.bottom);
    right = std::max(right, other.right);
    top = std::max(top, other.top);
  }
};

/// Rasterises the glyphs of a line at their positions.
class Typesetter {
 public:
  Typesetter(const std::string& path, FT_Library library, FT_Face face, const ShapedLine& line,
             std::uint32_t em)
      : path_(path), library_(library), face_(face), line_(line), em_(em) {}

  Box bounds() {
    Box box;
    for (const PlacedGlyph& glyph : line_.glyphs) box.add(touched(outline(glyph)));
    if (box.is_empty()) box = {0, 0, 1, 1};
    return {box.left - margin, box.bottom - margin, box.right + margin, box.top + margin};
  }

  /// Adds the glyphs' coverage to an image of this box.
  void draw(const Box& box, StampImage& image) {
    for (const PlacedGlyph& glyph : line_.glyphs) {
      FT_Outline& shape = outline(glyph);
      if (const Box part = touched(shape); !part.is_empty()) add(shape, part, box, image);
    }
  }

 private:
  /// A length in FreeType's unit, 1/64 of a texel.
  FT_Pos place(std::int64_t font_units) const {
    return static_cast<FT_Pos>(std::llround(static_cast<double>(font_units) * 64 * em_ / line_.units_per_em));
  }

  FT_Outline& outline(const PlacedGlyph& glyph) {
    if (FT_Load_Glyph(face_, glyph.glyph, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP) != 0 ||
        face_->glyph->format != FT_GLYPH_FORMAT_OUTLINE)
      throw FileError(path_, fmt::format("the font's glyph {} cannot be read", glyph.glyph));
    FT_Outline_Translate(&face_->glyph->outline, place(glyph.x), place(glyph.y));
    return face_->glyph->outline;
  }

  static Box touched(FT_Outline& shape) {
    if (shape.n_points == 0) return {};
    FT_BBox box;
    FT_Outline_Get_CBox(&shape, &box);
    const auto whole = [](FT_Pos place) { return static_cast<std::int64_t>(place >> 6); };
    return {whole(box.xMin), whole(box.yMin), whole(box.xMax + 63), whole(box.yMax + 63)};
  }

  void add(FT_Outline& shape, const Box& part, const Box& box, StampImage& image) {
    const auto width = static_cast<std::size_t>(part.right - part.left);
    const auto height = static_cast<std::size_t>(part.top - part.bottom);
    std::vector<unsigned char> coverage(width * height);
    FT_Bitmap bitmap{};
    bitmap.width = static_cast<unsigned>(width);
    bitmap.rows = static_cast<unsigned>(height);
    bitmap.pitch = static_cast<int>(width);  // positive: rows from the top
    bitmap.buffer = coverage.data();
    bitmap.num_grays = 256;
    bitmap.pixel_mode = FT_PIXEL_MODE_GRAY;
    FT_Outline_Translate(&shape, static_cast<FT_Pos>(-part.left * 64),
                         static_cast<FT_Pos>(-part.bottom * 64));
    if (FT_Outline_Get_Bitmap(library_, &shape, &bitmap) != 0)
      throw FileError(path_, "an outline of the font cannot be drawn");
    for (std::size_t y = 0; y < height; ++y) {
      const std::size_t row = static_cast<std::size_t>(box.top - part.top) + y;
      float* texel =
          image.texels.data() + row * static_cast<std::size_t>(image.width) + (part.left - box.left);
      for (std::size_t x = 0; x < width; ++x, ++texel)
        *texel = std::min(1.0f, *texel + static_cast<float>(coverage[y * width + x]) / 255);
    }
  }

  const std::string& path_;
  FT_Library library_;
  FT_Face face_;
  const ShapedLine& line_;
  std::uint32_t em_;
};

StampImage blank(const Box& box) {
  const std::int64_t width = box.right - box.left, height = box.top - box.bottom;
  if (width > most_texels / height)
    throw Error(fmt::format("the text makes an image of {} x {} texels, more than 2^28", width, height));
  StampImage image{.width = static_cast<int>(width),
                   .height = static_cast<int>(height),
                   .channels = 1,
                   .texels = std::vector<float>(static_cast<std::size_t>(width * height)),
                   .wrap_u = Wrap::black,
                   .wrap_v = Wrap::black};
  return image;
}

}  // namespace

Lettering set_lettering(const std::filesystem::path& font, std::string_view text, std::uint32_t em) {
  if (em < min_em || em > max_em)
    throw ContractError(
        fmt::format("set_lettering: an em of {} texels; it must be {} to {}", em, min_em, max_em));
  const std::string path = font.string(), bytes = read_file(font);
  const ShapedLine line = shape_line(font, bytes, text);
  const Library library = open_library();
  const Face face = open_face(library.get(), path, bytes, em);
  Typesetter typesetter(path, library.get(), face.get(), line, em);
  const Box box = typesetter.bounds();
  Lettering lettering{};
  lettering.image = blank(box);
  typesetter.draw(box, lettering.image);
  set_range(lettering.image);
  const auto ems = [&](std::int64_t units) {
    return static_cast<float>(static_cast<double>(units) / line.units_per_em);
  };
  const auto border = [&](std::int64_t texels) {
    return static_cast<float>(static_cast<double>(texels) / em);
  };
  lettering.width = ems(line.width);
  lettering.ascent = ems(line.ascent);
  lettering.descent = ems(line.descent);
  lettering.left = border(box.left);
  lettering.right = border(box.right);
  lettering.bottom = border(box.bottom);
  lettering.top = border(box.top);
  return lettering;
}

}  // namespace burin
