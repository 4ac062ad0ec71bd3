#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/stamp/lettering/font_search.h>
#include <burin/stamp/lettering/lettering.h>
#include <freetype/freetype.h>
#include <freetype/ftoutln.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/error_of.h"
#include "support/shared_data.h"

namespace burin {
namespace {

namespace fs = std::filesystem;

/// The font's own word, in font units.
class Metrics {
 public:
  explicit Metrics(const fs::path& font) {
    EXPECT_EQ(FT_Init_FreeType(&library_), 0);
    EXPECT_EQ(FT_New_Face(library_, font.string().c_str(), 0, &face_), 0);
  }
  Metrics(const Metrics&) = delete;
  Metrics& operator=(const Metrics&) = delete;
  ~Metrics() { FT_Done_FreeType(library_); }

  double ems(FT_Pos units) const { return static_cast<double>(units) / face_->units_per_EM; }
  FT_GlyphSlot glyph(char32_t code) const {
    EXPECT_EQ(FT_Load_Char(face_, code, FT_LOAD_NO_SCALE), 0);
    return face_->glyph;
  }
  double advance(char32_t code) const { return ems(glyph(code)->metrics.horiAdvance); }
  double ascent() const { return ems(face_->ascender); }
  double descent() const { return -ems(face_->descender); }
  FT_Face face() const { return face_; }

 private:
  FT_Library library_ = nullptr;
  FT_Face face_ = nullptr;
};

/// Signed area of an outline in square ems: each piece of it, straight, quadratic or cubic, cut into chords.
class OutlineArea {
 public:
  explicit OutlineArea(const Metrics& metrics, char32_t code) : metrics_(metrics) {
    FT_Outline outline = metrics.glyph(code)->outline;
    const FT_Outline_Funcs pieces{
        [](const FT_Vector* to, void* self) { return static_cast<OutlineArea*>(self)->move(to); },
        [](const FT_Vector* to, void* self) {
          auto& area = *static_cast<OutlineArea*>(self);
          return area.curve({area.at_, *to});
        },
        [](const FT_Vector* control, const FT_Vector* to, void* self) {
          auto& area = *static_cast<OutlineArea*>(self);
          return area.curve({area.at_, *control, *to});
        },
        [](const FT_Vector* a, const FT_Vector* b, const FT_Vector* to, void* self) {
          auto& area = *static_cast<OutlineArea*>(self);
          return area.curve({area.at_, *a, *b, *to});
        },
        0,
        0};
    EXPECT_EQ(FT_Outline_Decompose(&outline, &pieces, this), 0);
  }
  double square_ems() const { return std::abs(sum_); }

 private:
  int move(const FT_Vector* to) {
    at_ = *to;
    return 0;
  }
  int curve(std::vector<FT_Vector> controls) {
    double x0 = metrics_.ems(at_.x), y0 = metrics_.ems(at_.y);
    for (int i = 1; i <= 1000; ++i) {
      const auto [x, y] = casteljau(controls, i / 1000.0);
      sum_ += (x0 * y - x * y0) / 2;
      x0 = x;
      y0 = y;
    }
    at_ = controls.back();
    return 0;
  }
  std::pair<double, double> casteljau(const std::vector<FT_Vector>& controls, double s) const {
    std::vector<std::pair<double, double>> points;
    for (const FT_Vector& control : controls)
      points.emplace_back(metrics_.ems(control.x), metrics_.ems(control.y));
    for (; points.size() > 1; points.pop_back())
      for (std::size_t i = 0; i + 1 < points.size(); ++i)
        points[i] = {points[i].first * (1 - s) + points[i + 1].first * s,
                     points[i].second * (1 - s) + points[i + 1].second * s};
    return points[0];
  }

  const Metrics& metrics_;
  FT_Vector at_{};
  double sum_ = 0;
};

fs::path dejavu() { return find_font("DejaVuSans.ttf"); }

double covered_square_ems(const Lettering& lettering, std::uint32_t em) {
  double sum = 0;
  for (const float texel : lettering.image.texels) sum += double{texel};
  return sum / em / em;
}

/// Borders of what is covered to a half or more, in ems.
struct Ink {
  float left, right, bottom, top;
};

Ink ink(const Lettering& lettering) {
  const StampImage& image = lettering.image;
  int left = image.width, right = 0, top = image.height, bottom = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      if (image.texels[static_cast<std::size_t>(y * image.width + x)] < 0.5f) continue;
      left = std::min(left, x);
      right = std::max(right, x + 1);
      top = std::min(top, y);
      bottom = std::max(bottom, y + 1);
    }
  const float x_em = (lettering.right - lettering.left) / static_cast<float>(image.width);
  const float y_em = (lettering.top - lettering.bottom) / static_cast<float>(image.height);
  return {lettering.left + static_cast<float>(left) * x_em, lettering.left + static_cast<float>(right) * x_em,
          lettering.top - static_cast<float>(bottom) * y_em, lettering.top - static_cast<float>(top) * y_em};
}

std::string complaint(const fs::path& font, std::string_view text) {
  return test::error_of([&] { set_lettering(font, text, 32); });
}

TEST(Lettering, IsAsWideAsTheFontSays) {
  const Metrics metrics(dejavu());
  for (const char32_t code : U"AgMiö€ 7") {
    if (code == 0) break;
    std::string text;
    if (code < 0x80)
      text = static_cast<char>(code);
    else if (code < 0x800)
      text = {static_cast<char>(0xc0 | code >> 6), static_cast<char>(0x80 | (code & 0x3f))};
    else
      text = "€";
    EXPECT_NEAR(set_lettering(dejavu(), text, 16).width, metrics.advance(code), 1e-6) << text;
  }
  EXPECT_NEAR(set_lettering(dejavu(), "Hill", 16).width,
              metrics.advance('H') + metrics.advance('i') + 2 * metrics.advance('l'), 1e-6);
}

TEST(Lettering, IsKerned) {
  const Metrics metrics(dejavu());
  FT_Vector kerning{};
  ASSERT_EQ(FT_Get_Kerning(metrics.face(), FT_Get_Char_Index(metrics.face(), 'A'),
                           FT_Get_Char_Index(metrics.face(), 'V'), FT_KERNING_UNSCALED, &kerning),
            0);
  const Lettering a = set_lettering(dejavu(), "A", 64), v = set_lettering(dejavu(), "V", 64),
                  both = set_lettering(dejavu(), "AV", 64);
  EXPECT_LT(both.width, a.width + v.width - 0.03f);
  if (kerning.x != 0) {
    EXPECT_NEAR(both.width, a.width + v.width + metrics.ems(kerning.x), 1e-6);
  }
  // The letters stand as close as the width says: the V ends where it would alone, but for the pair's
  // kerning.
  EXPECT_NEAR(ink(both).right - ink(v).right, both.width - v.width, 1.5 / 64);
  EXPECT_NEAR(ink(both).left, ink(a).left, 1e-6);
  // Neither wipes out what the other covers of the texels that they share.
  EXPECT_NEAR(covered_square_ems(both, 64), covered_square_ems(a, 64) + covered_square_ems(v, 64), 1e-3);
}

TEST(Lettering, CoversTheOutlinesArea) {
  const Metrics metrics(dejavu());
  for (const char letter : {'I', 'O', 'B', 'g', '%'}) {
    const double area = OutlineArea(metrics, static_cast<char32_t>(letter)).square_ems();
    for (const std::uint32_t em : {16u, 64u, 256u}) {
      const double covered = covered_square_ems(set_lettering(dejavu(), std::string(1, letter), em), em);
      EXPECT_NEAR(covered / area, 1, 0.4 / em) << letter << " at " << em;
    }
  }
}

TEST(Lettering, StandsOnItsBaseline) {
  const Metrics metrics(dejavu());
  const Lettering line = set_lettering(dejavu(), "H", 128);
  EXPECT_NEAR(line.ascent, metrics.ascent(), 1e-6);
  EXPECT_NEAR(line.descent, metrics.descent(), 1e-6);
  const FT_Glyph_Metrics h = metrics.glyph('H')->metrics;
  EXPECT_NEAR(ink(line).bottom, 0, 0.6 / 128);
  EXPECT_NEAR(ink(line).top, metrics.ems(h.height), 0.6 / 128);
  EXPECT_NEAR(ink(line).left, metrics.ems(h.horiBearingX), 0.6 / 128);
  EXPECT_NEAR(ink(line).right, metrics.ems(h.horiBearingX + h.width), 0.6 / 128);
  const FT_Glyph_Metrics g = metrics.glyph('g')->metrics;
  EXPECT_NEAR(ink(set_lettering(dejavu(), "g", 128)).bottom, metrics.ems(g.horiBearingY - g.height),
              0.6 / 128);
}

TEST(Lettering, HasWholeTexelsAndAMargin) {
  const Lettering line = set_lettering(dejavu(), "Burin", 48);
  EXPECT_NEAR((line.right - line.left) * 48, line.image.width, 1e-3);
  EXPECT_NEAR((line.top - line.bottom) * 48, line.image.height, 1e-3);
  EXPECT_EQ(line.image.channels, 1);
  EXPECT_EQ(line.image.minimum, 0);
  EXPECT_EQ(line.image.maximum, 1);
  EXPECT_EQ(line.image.wrap_u, Wrap::black);
  EXPECT_EQ(line.image.wrap_v, Wrap::black);
  for (int y = 0; y < line.image.height; ++y)
    for (int x = 0; x < line.image.width; ++x) {
      if (x >= 4 && y >= 4 && x < line.image.width - 4 && y < line.image.height - 4) continue;
      ASSERT_EQ(line.image.texels[static_cast<std::size_t>(y * line.image.width + x)], 0) << x << " " << y;
    }
}

// Letters are placed at fractions of a texel: in a row of equal letters the texels differ from letter to
// letter, but every letter has the same area.
TEST(Lettering, PlacesLettersAtFractionsOfATexel) {
  const Metrics metrics(dejavu());
  const double one = OutlineArea(metrics, 'l').square_ems();
  const Lettering row = set_lettering(dejavu(), "llllllll", 11);
  EXPECT_NEAR(covered_square_ems(row, 11) / one, 8, 0.2);
  std::vector<std::vector<float>> starts;
  const int middle = row.image.height / 2;
  for (int i = 0; i < 8; ++i) {
    const int x = static_cast<int>((i * metrics.advance('l') - double{row.left}) * 11);
    const float* texel = &row.image.texels[static_cast<std::size_t>(middle * row.image.width + x)];
    starts.emplace_back(texel, texel + 3);
  }
  std::ranges::sort(starts);
  EXPECT_GT(std::unique(starts.begin(), starts.end()) - starts.begin(), 4);
}

TEST(Lettering, OfSpacesIsBlank) {
  const Lettering line = set_lettering(dejavu(), "  ", 32);
  EXPECT_NEAR(line.width, 2 * Metrics(dejavu()).advance(' '), 1e-6);
  EXPECT_EQ(line.image.maximum, 0);
}

TEST(Lettering, IsTheSameEveryTime) {
  const Lettering first = set_lettering(dejavu(), "To Wave, 1885", 40),
                  second = set_lettering(dejavu(), "To Wave, 1885", 40);
  EXPECT_EQ(first.image.texels, second.image.texels);
}

TEST(Lettering, RefusesWhatItCannotSet) {
  const std::string font = dejavu().string();
  EXPECT_EQ(complaint(dejavu(), ""), "there is no text to set");
  EXPECT_EQ(complaint(dejavu(), "two\nlines"), "the text is no single line: it holds U+000A at byte 3");
  EXPECT_EQ(complaint(dejavu(), "a\xe2\x80\xa8"), "the text is no single line: it holds U+2028 at byte 1");
  EXPECT_EQ(complaint(dejavu(), "caf\xe9"), "the text is no UTF-8 at byte 3");
  EXPECT_EQ(complaint(dejavu(), "a 漢字"), font + ": the font has no glyph for '漢' (U+6F22)");
  EXPECT_THROW(set_lettering(dejavu(), "a", 7), ContractError);
  EXPECT_THROW(set_lettering(dejavu(), "a", 513), ContractError);
  EXPECT_NE(complaint(dejavu(), std::string(20000, 'a')), "none");
}

TEST(Lettering, RefusesFilesThatAreNoFonts) {
  test::TemporaryFolder folder;
  const auto write = [&](const char* name, std::string_view bytes) {
    write_file_whole(folder.path() / name, [&](std::ostream& out) { out << bytes; });
    return folder.path() / name;
  };
  const std::string whole = read_file(dejavu());
  EXPECT_EQ(complaint(write("text.ttf", "this is no font"), "a"),
            (folder.path() / "text.ttf").string() + ": is no font");
  EXPECT_EQ(complaint(write("empty.ttf", ""), "a"), (folder.path() / "empty.ttf").string() + ": is no font");
  EXPECT_NE(complaint(folder.path() / "none.ttf", "a"), "none");
  EXPECT_NE(complaint(write("cut.ttf", std::string_view(whole).substr(0, 1000)), "a"), "none");
  for (std::size_t size = 2000; size < 600000; size += 50021)
    EXPECT_NE(complaint(write("cut.ttf", std::string_view(whole).substr(0, size)), "a"), "none") << size;
}

}  // namespace
}  // namespace burin
