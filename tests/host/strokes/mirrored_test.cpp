// Tests symmetric strokes with every brush, every kind of overlap and accumulation.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "host/mirrored_hills.h"
#include "host/stock_brush_uses.h"

namespace burin {
namespace {

using test::BrushUse;

constexpr double mirrored_radius = 0.2;

Vec3f mirrored(const Vec3f& place) { return {-place.x(), place.y(), place.z()}; }

std::vector<Vec3d> way(const Vec3d& from, const Vec3d& to, double bend) {
  std::vector<Vec3d> places;
  for (int i = 0; i <= 24; ++i) {
    const double s = i / 24.;
    places.push_back(from + s * (to - from) + bend * std::sin(3 * s) * Vec3d(1, 0, 0));
  }
  return places;
}

struct Way {
  const char* name;
  std::vector<Vec3d> places;
};

const std::vector<Way> ways = {{"near the plane", way({0.08, -0.4, 0}, {0.12, 0.4, 0}, 0.05)},
                               {"across it", way({-0.35, -0.3, 0}, {0.4, 0.25, 0}, 0.05)},
                               {"on it", way({0, -0.4, 0}, {0, 0.4, 0}, 0)}};

class Mirrored : public testing::TestWithParam<BrushUse> {
 protected:
  Mirrored() : session_(make_surface(test::mirrored_hills()), test::brushes()) {
    std::map<std::pair<long, long>, Index> at;
    const auto key = [](const Vec3f& place) {
      return std::pair(std::lround(100 * place.x()), std::lround(100 * place.y()));
    };
    const std::vector<Vec3f>& places = session_.surface().positions;
    for (Index vertex = 0; vertex < places.size(); ++vertex) at[key(places[vertex])] = vertex;
    for (const Vec3f& place : places) partner_.push_back(at.at(key(mirrored(place))));
  }

  StrokeSettings stroke(bool mirror) const {
    StrokeSettings settings = test::settings(GetParam().id, mirrored_radius);
    settings.params = GetParam().params;
    settings.symmetry.mirror_x = mirror;
    return settings;
  }

  struct Result {
    double asymmetry = 0, farthest = 0;  ///< object units
  };
  Result drawn(const StrokeSettings& settings, const std::vector<Vec3d>& places) {
    session_.begin_stroke(settings);
    double time = 0;
    for (const Vec3d& place : places) session_.add_sample(place, time += 0.01, {}, Show::later);
    session_.end_piece();
    Result result;
    for (Index vertex = 0; vertex < partner_.size(); ++vertex) {
      const Vec3f place = session_.positions()[vertex], other = session_.positions()[partner_[vertex]];
      const Vec3f moved = place - session_.surface().positions[vertex];
      result.asymmetry = std::max(result.asymmetry, static_cast<double>((mirrored(other) - place).norm()));
      result.farthest = std::max(result.farthest, static_cast<double>(moved.norm()));
    }
    session_.cancel_stroke();
    return result;
  }

  void expect_symmetry(StrokeSettings settings, const std::string& how) {
    for (const Way& way : ways) {
      const Result result = drawn(settings, way.places);
      EXPECT_GT(result.farthest, 1e-4) << how << ' ' << way.name;
      EXPECT_LE(result.asymmetry, 1e-5 * mirrored_radius) << how << ' ' << way.name;
    }
    const std::vector<Vec3d>& on_plane = ways.back().places;
    const double with = drawn(settings, on_plane).farthest;
    settings.symmetry = {};
    EXPECT_LE(with, 1.0001 * drawn(settings, on_plane).farthest) << how;
  }

  Session session_;
  std::vector<Index> partner_;
};

/// All stock brushes except text, which stays readable in mirror images.
std::vector<BrushUse> brushes_that_mirror() {
  std::vector<BrushUse> uses;
  for (const BrushUse& use : test::stock_brush_uses)
    if (std::string_view(use.id) != "org.burin.text") uses.push_back(use);
  return uses;
}

INSTANTIATE_TEST_SUITE_P(StockBrushes, Mirrored, testing::ValuesIn(brushes_that_mirror()), test::name_of_use);

TEST_P(Mirrored, WhateverOverlaps) {
  for (const auto& [name, overlap] : named_overlaps) {
    StrokeSettings settings = stroke(true);
    settings.overlap = overlap;
    expect_symmetry(settings, std::string(name));
  }
}

TEST_P(Mirrored, WhereItGoesOnFromWhatItMade) {
  StrokeSettings settings = stroke(true);
  settings.accumulate = Accumulate::from_current;
  if (std::string_view(GetParam().id) == "org.burin.smooth") settings.params["passes"] = 1.0;
  expect_symmetry(settings, "accumulated");
}

}  // namespace
}  // namespace burin
