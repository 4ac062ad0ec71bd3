#pragma once
#include <burin/stroke/recording.h>

#include <Eigen/Geometry>
#include <vector>

namespace burin {

/// The box around x and y of all samples.
Eigen::AlignedBox2d flat_box_of(const std::vector<RecordedStroke>& strokes);

/// A uniform scale and a move of positions in a plane.
struct Placement {
  double scale = 1;
  Eigen::Vector2d from = Eigen::Vector2d::Zero(), to = Eigen::Vector2d::Zero();  ///< `from` goes to `to`
};

void place(std::vector<RecordedStroke>& strokes, const Placement& placement);

/// The placement that fits a box into the camera's viewport less a margin, as a share of it, on each side.
Placement view_placement(const Eigen::AlignedBox2d& box, const Camera& camera, double margin);

/// Scales and moves strokes so that they fill the camera's viewport less a margin of 10 % on each side.
void fit_to_view(std::vector<RecordedStroke>& strokes, const Camera& camera);

}  // namespace burin
