// Tests the rules that combine the sheets of a vertex.
#include <burin/deform/blend/combine_sheets.h>
#include <burin/deform/blend/sheet_shares.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace burin {
namespace {

constexpr double radius = 0.5;

Sheet sheet_of(const Vec3f& displacement, double inside, double t = 0, std::uint32_t image = 0) {
  return {.e1 = Vec3f::UnitX(),
          .normal = Vec3f::UnitZ(),
          .displacement = displacement,
          .tint = Tint::Zero(),
          .inside = inside,
          .t = t,
          .piece = 0,
          .image = image};
}

std::vector<Sheet> random_sheets(std::mt19937& random, std::size_t count) {
  std::uniform_real_distribution<float> number(-1, 1);
  std::vector<Sheet> sheets;
  for (std::size_t i = 0; i < count; ++i) {
    sheets.push_back(sheet_of({number(random), number(random), number(random)}, 0.5 + number(random) / 2.,
                              number(random), random() % 2));
    for (float& channel : sheets.back().tint) channel = 0.5f + number(random) / 2;
  }
  return sheets;
}

Tint before() { return Tint(0, 0.5f, 0, 0.5f, 1); }

TEST(SheetShares, AddUpToOneAndGiveAllToOneThatIsAlone) {
  std::mt19937 random(1);
  for (int round = 0; round < 300; ++round) {
    std::vector<Sheet> sheets = random_sheets(random, 1 + random() % 6);
    if (round % 3 == 0) sheets.front().inside = 0;
    std::vector<double> keys;
    for (const Sheet& sheet : sheets) keys.push_back(sheet.displacement.z());
    for (const Shares& shares : {mean_shares(sheets), stacked_shares(sheets, keys), latest_shares(sheets),
                                 softly_stacked_shares(sheets, keys, 0.1)}) {
      ASSERT_EQ(shares.size(), sheets.size());
      ASSERT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0), 1, 1e-9);
      ASSERT_GE(std::ranges::min(shares), 0);
      if (sheets.size() == 1) {
        ASSERT_EQ(shares.front(), 1);
      }
    }
  }
}

TEST(SheetShares, AreThoseOfTheLatestSheetUntilItFades) {
  const std::vector<Sheet> sheets = {sheet_of(Vec3f::Zero(), 1, 0.1), sheet_of(Vec3f::Zero(), 0.9, 0.7),
                                     sheet_of(Vec3f::Zero(), 0.3, 0.9)};
  const Shares shares = latest_shares(sheets);
  const double weight = 0.4 * 0.4 * (3 - 0.8);
  EXPECT_NEAR(shares[2], weight, 1e-12);
  EXPECT_NEAR(shares[1], 1 - weight, 1e-12);
  EXPECT_EQ(shares[0], 0);
}

TEST(SheetShares, TakeLaterPiecesForLater) {
  std::vector<Sheet> sheets = {sheet_of(Vec3f::Zero(), 1, 0.1), sheet_of(Vec3f::Zero(), 1, 0.7)};
  sheets[0].piece = 1;
  EXPECT_EQ(latest_shares(sheets), (Shares{1, 0}));
}

TEST(CombinedSheets, DoNotFeelASheetAtItsRim) {
  std::mt19937 random(2);
  for (int round = 0; round < 300; ++round) {
    std::vector<Sheet> sheets = random_sheets(random, 1 + random() % 5);
    for (const auto& [name, overlap] : named_overlaps) {
      const Vec3d without = combined_move(sheets, overlap, radius);
      const Tint tint_without = combined_tint(sheets, overlap, before());
      std::vector<Sheet> with = sheets;
      with.push_back(random_sheets(random, 1).front());
      with.back().inside = 1e-6;
      with.back().image = sheets.front().image;
      // These take all that sheets do; what a brush does at its rim is nothing.
      const bool all_counts = overlap == Overlap::strongest || overlap == Overlap::add;
      if (all_counts) with.back().displacement.setZero();
      if (all_counts) with.back().tint = before();
      std::ranges::shuffle(with, random);
      ASSERT_LT((combined_move(with, overlap, radius) - without).norm(), 1e-4) << name;
      ASSERT_LT((combined_tint(with, overlap, before()) - tint_without).norm(), 1e-4f) << name;
    }
  }
}

TEST(CombinedSheets, HaveNoStepWhereSheetsChangeALittle) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> number(-1, 1);
  for (int round = 0; round < 300; ++round) {
    const std::vector<Sheet> sheets = random_sheets(random, 2 + random() % 4);
    std::vector<Sheet> nudged = sheets;
    // Two that were at the same height now change places.
    for (Sheet& sheet : nudged)
      sheet.displacement += 1e-5f * Vec3f(number(random), number(random), number(random));
    for (const auto& [name, overlap] : named_overlaps)
      ASSERT_LT((combined_move(nudged, overlap, radius) - combined_move(sheets, overlap, radius)).norm(),
                5e-3)
          << name;
  }
  // The sheets have the same height and opposite sideways displacements.
  const Sheet left = sheet_of({-1, 0, 0.5f}, 0.9), right = sheet_of({1, 0, 0.5f}, 0.9);
  for (const auto& [name, overlap] : named_overlaps) {
    if (overlap == Overlap::latest) continue;
    Sheet higher = left;
    higher.displacement.z() += 1e-6f;
    EXPECT_LT(
        (combined_move({higher, right}, overlap, radius) - combined_move({left, right}, overlap, radius))
            .norm(),
        1e-4)
        << name;
  }
}

TEST(CombinedSheets, DoNotDependOnTheirOrder) {
  std::mt19937 random(4);
  for (int round = 0; round < 300; ++round) {
    std::vector<Sheet> sheets = random_sheets(random, 2 + random() % 5);
    for (const auto& [name, overlap] : named_overlaps) {
      const Vec3d move = combined_move(sheets, overlap, radius);
      const Tint tint = combined_tint(sheets, overlap, before());
      std::ranges::shuffle(sheets, random);
      ASSERT_EQ(combined_move(sheets, overlap, radius), move) << name;
      ASSERT_EQ(combined_tint(sheets, overlap, before()), tint) << name;
    }
  }
}

TEST(CombinedSheets, OfTwoImagesThatAreOneAreNoStrongerThanOne) {
  const Vec3f displacement(0.1f, 0.2f, -0.3f);
  const std::vector<Sheet> sheets = {sheet_of(displacement, 0.8, 1, 0), sheet_of(displacement, 0.8, 1, 1)};
  for (const auto& [name, overlap] : named_overlaps)
    EXPECT_LT((combined_move(sheets, overlap, radius) - displacement.cast<double>()).norm(), 1e-7) << name;
}

}  // namespace
}  // namespace burin
