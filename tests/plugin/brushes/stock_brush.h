#pragma once
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "plugin/driver.h"

namespace burin::test {

/// The outputs of a brush for nodes.
struct Displaced {
  std::vector<float> along, across, up;
};

/// n + 1 places from 0 to `last`.
std::vector<float> steps(int n, float last);

/// A stock brush that a test asks for displacements, and what holds for all of those that compute them from
/// (t, d). At first its stroke is open, of length 10 and radius 1.
class StockBrush : public testing::Test {
 protected:
  explicit StockBrush(const std::string& name);

  /// Begins the stroke anew and evaluates.
  Displaced evaluate(const Nodes& nodes);
  /// The displacement of one node at (t, d) whose half width is the stroke's radius.
  Vector at(float t, float d);

  /// Places of the chart, caps included.
  Nodes random_nodes(std::size_t count);

  /// Expects that the displacement changes by at most `steepest` per length along straight lines through the
  /// chart and past its border, and that it is 0 outside the chart.
  void expect_no_step(float steepest);

  /// Around a closed stroke, what is at t = 0 is at t = length.
  void expect_closed_seam();

  /// Twice the stroke gives twice the displacement.
  void expect_scale_invariance();

  /// Expects that displacements at d and -d are mirror images.
  void expect_same_on_both_sides();

  /// Open, closed and dabs, of no length and much, small and large, with parameters all over their sliders.
  void expect_finite();

  /// Fills in what the brush reads besides t, d and radius.
  virtual void add_inputs(Nodes&) {}

  /// Seed of `engine_`, printed.
  const unsigned seed_;
  std::mt19937 engine_;
  float random(float low, float high) { return std::uniform_real_distribution<float>(low, high)(engine_); }

  PluginModule module_;
  TestHost host_;
  StrokeDriver stroke_;
  const burin_brush_descriptor& descriptor_;

 private:
  void set_size(double radius, double length);
  void set_random_params();
  bool in_chart(float t, float d) const;
};

}  // namespace burin::test
