#include "support/shapes.h"

#include <burin/deform/earlier_pieces.h>
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <vector>

namespace burin {
namespace {

/// One vertex of a level surface that pieces move up or down one after the other.
class EarlierPiecesTest : public ::testing::Test {
 protected:
  /// Where the vertex is after pieces with so many nodes there would have moved it this far, each by itself.
  float height(Overlap overlap, const std::vector<std::pair<std::uint32_t, float>>& pieces,
               double limit = std::numeric_limits<double>::infinity()) {
    EarlierPieces earlier(surface_, {.overlap = overlap, .limit = limit});
    Vec3f place;
    for (const auto& [sheets, up] : pieces) {
      place = base() + Vec3f(0, 0, up);
      const std::array<std::uint32_t, 1> counts{sheets};
      const PieceMoves piece{vertex_, counts, {&place, 1}, {}};
      earlier.blend({}, piece);
      earlier.add(piece);
    }
    return place.z() - base().z();
  }

  Tint tint(Overlap overlap, const Tint& first, const Tint& second, const Paint& paint = {}) {
    EarlierPieces earlier(surface_, {.overlap = overlap});
    const std::array<std::uint32_t, 1> counts{1};
    Tint now;
    for (const Tint& written : {first, second}) {
      now = written;
      Vec3f place = base();
      const PieceMoves piece{vertex_, counts, {&place, 1}, {&now, 1}};
      earlier.blend(paint, piece);
      earlier.add(piece);
    }
    return now;
  }

  const Vec3f& base() const { return surface_.positions[vertex_[0]]; }

  Surface surface_ = make_surface(test::plane(1, 0.5, 1));
  std::array<Index, 1> vertex_{7};
};

TEST_F(EarlierPiecesTest, AreBlendedAsSheetsAre) {
  EXPECT_FLOAT_EQ(height(Overlap::latest, {{1, -0.5F}, {1, -0.25F}}), -0.25F);
  EXPECT_FLOAT_EQ(height(Overlap::max, {{1, -0.5F}, {1, -0.25F}}), -0.25F);
  EXPECT_FLOAT_EQ(height(Overlap::min, {{1, -0.5F}, {1, -0.25F}}), -0.5F);
  EXPECT_FLOAT_EQ(height(Overlap::max, {{1, 0.5F}, {1, 0.25F}, {1, 0.125F}}), 0.5F);
  EXPECT_FLOAT_EQ(height(Overlap::add, {{1, -0.5F}, {2, -0.25F}, {1, 0.125F}}), -0.625F);
  EXPECT_FLOAT_EQ(height(Overlap::average, {{1, -0.5F}, {2, -0.125F}, {1, 0.25F}}), -0.125F);
}

TEST_F(EarlierPiecesTest, StayWhereTheLaterPieceHasNoNode) {
  for (const Overlap overlap : {Overlap::latest, Overlap::max, Overlap::min, Overlap::add, Overlap::average})
    EXPECT_FLOAT_EQ(height(overlap, {{1, -0.5F}, {0, 0}}), -0.5F);
}

TEST_F(EarlierPiecesTest, KeepTheirSumWithinTheLimit) {
  EXPECT_FLOAT_EQ(height(Overlap::add, {{1, -0.5F}, {1, -0.25F}}, 0.625), -0.625F);
}

TEST_F(EarlierPiecesTest, BlendTints) {
  Tint red, green;
  red << 0.5F, 0, 0, 0.5F, 0.25F;
  green << 0, 0.75F, 0, 0.75F, 0.75F;
  EXPECT_EQ(tint(Overlap::latest, red, green), green);
  EXPECT_EQ(tint(Overlap::max, red, green), red.cwiseMax(green));
  EXPECT_EQ(tint(Overlap::min, red, green), red.cwiseMin(green));
  Tint sum, mean;
  sum << 0.5F, 0.75F, 0, 1, 0;  // masks take off 0.75 and 0.25
  mean << 0.25F, 0.375F, 0, 0.625F, 0.5F;
  EXPECT_EQ(tint(Overlap::add, red, green), sum);
  EXPECT_EQ(tint(Overlap::average, red, green), mean);
}

}  // namespace
}  // namespace burin
