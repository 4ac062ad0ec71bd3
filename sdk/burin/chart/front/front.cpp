// Runs the parts of a front: replaces what changed of the curve, then lets the parts advance in steps of
// about half an edge, each on its own thread, and exchanges what happened at their borders between the steps.
#include <burin/base/parallel.h>
#include <burin/base/threads/run_concurrently.h>
#include <burin/chart/front/front.h>
#include <burin/chart/path/curve_parts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace burin {
namespace {

bool same_for_charts(const CurvePoint& a, const CurvePoint& b) {
  return a.at.corners == b.at.corners && a.at.position == b.at.position && a.normal == b.normal &&
         a.tangent == b.tangent && a.t == b.t && a.width == b.width;
}

/// The least step of parts, in radii: they get on where the curve has no length, too.
constexpr double least_step = 1.0 / 1024;

/// Samples and points of a stroke are no finer than this share of the surface.
constexpr double finest_share = 1e-5;

}  // namespace

Front::Front(const ChartGround& ground)
    : ground_(ground), blocks_(ChartNodes::blocks_of(ground.vertex_count()), 0) {}

void Front::restart(double radius, int order, const Extensions& extensions) {
  stroke_.radius = radius;
  stroke_.order = order;
  stroke_.extensions = extensions;
  stroke_.samples.clear();
  stroke_.path.clear();
  stroke_.curve.points.clear();
}

void Front::update(const SurfaceCurve& curve, std::size_t unchanged, std::size_t parts) {
  if (curve.closed || stroke_.samples.closed()) restart(stroke_.radius, stroke_.order, stroke_.extensions);
  if (stroke_.curve.points.empty()) cut(curve, ground_.concurrent() ? parts : 1);
  const CurveChange change = replace_curve(curve, std::min(unchanged, stroke_.curve.points.size()));
  if (parts_.size() > 1) return advance_in_steps(change);
  parts_[0]->change(change);
  parts_[0]->advance(unreached);
}

/// Cuts the vertices where as many points of the curve lie on either side.
void Front::cut(const SurfaceCurve& curve, std::size_t parts) {
  std::vector<Index> corners;
  for (const CurvePoint& point : curve.points) corners.push_back(point.at.corners[0]);
  std::ranges::sort(corners);
  while (parts_.size() < parts) parts_.push_back(std::make_unique<FrontPart>(ground_, stroke_, blocks_));
  parts_.resize(parts);
  VertexRange range{0, 0};
  for (std::size_t part = 1; part <= parts; ++part) {
    const bool last = part == parts;
    const Index middle = corners[std::min(corners.size() * part / parts, corners.size() - 1)];
    const Index whole_blocks = middle / ChartNodes::block_size * ChartNodes::block_size;
    range.end = last ? ground_.vertex_count() : std::max(range.begin, whole_blocks);
    parts_[part - 1]->restart(range);
    range.begin = range.end;
  }
}

CurveChange Front::replace_curve(const SurfaceCurve& curve, std::size_t unchanged) {
  std::vector<CurvePoint>& points = stroke_.curve.points;
  const auto from = static_cast<std::ptrdiff_t>(unchanged);
  const auto differ = std::mismatch(points.begin() + from, points.end(), curve.points.begin() + from,
                                    curve.points.end(), same_for_charts);
  unchanged = static_cast<std::size_t>(differ.first - points.begin());
  points.resize(unchanged);
  points.insert(points.end(), differ.second, curve.points.end());
  stroke_.curve.closed = curve.closed;
  stroke_.curve.closing_length = curve.closing_length;

  const double finest = finest_share * ground_.scale();
  const std::size_t bent = stroke_.curvature.update(curve, curvature_window * stroke_.radius, unchanged);
  stroke_.path.update(curve, stroke_.curvature, stroke_.radius, finest, std::min(bent, unchanged),
                      stroke_.extensions);
  CurveChange change{};
  change.first_sample = stroke_.samples.update(curve, stroke_.radius, finest, stroke_.extensions, unchanged);
  change.unchanged_t = change.first_sample > 0 && unchanged > 0
                           ? std::min(stroke_.samples.t(change.first_sample - 1), points[unchanged - 1].t)
                           : -std::numeric_limits<double>::infinity();
  unchanged_t_ = change.unchanged_t;
  // The segment before a point ends there; the one before that may have been the stroke's last.
  const std::size_t before_changed = std::min(bent, unchanged) > 2 ? std::min(bent, unchanged) - 2 : 0;
  change.first_segment = first_ending_from(curve, before_changed, change.unchanged_t);
  return change;
}

/// Each part has a thread. Between two steps all publish how far they are and what happened at their borders,
/// on one of two boards in turn: while the one is read the other is written.
void Front::advance_in_steps(const CurveChange& change) {
  struct Bulletin {
    float least_g = unreached;
    std::vector<BorderNode> reports;
  };
  // Half an edge, as points of the curve are apart: farther, and much would be taken back for what a
  // neighbouring part has to say.
  const double half_edge = stroke_.curve.length() / static_cast<double>(stroke_.curve.points.size());
  const auto step = static_cast<float>(std::max(half_edge, least_step * stroke_.radius));
  std::array<std::vector<Bulletin>, 2> boards{std::vector<Bulletin>(parts_.size()),
                                              std::vector<Bulletin>(parts_.size())};
  StepBarrier barrier(parts_.size());
  run_concurrently(parts_.size(), [&](std::size_t own) {
    FrontPart& part = *parts_[own];
    part.change(change);
    for (std::size_t round = 0;; ++round) {
      std::vector<Bulletin>& board = boards[round % 2];
      const std::span<const BorderNode> reports = part.reports();
      board[own].least_g = part.least_g();
      board[own].reports.assign(reports.begin(), reports.end());
      barrier.arrive_and_wait();
      float least = unreached;
      bool news = false;
      for (const Bulletin& bulletin : board) {
        least = std::min(least, bulletin.least_g);
        news = news || !bulletin.reports.empty();
      }
      if (least == unreached && !news) return;
      for (std::size_t other = 0; other < board.size(); ++other)
        if (other != own) part.receive(other, board[other].reports);
      part.advance(least + step);
    }
  });
}

std::vector<std::vector<const FrontNode*>> Front::inside() {
  std::vector<std::vector<const FrontNode*>> nodes(parts_.size());
  parallel_blocks(parts_.size(), 1,
                  [&](std::size_t part, std::size_t) { nodes[part] = parts_[part]->inside(); });
  return nodes;
}

std::uint64_t Front::settled() const {
  std::uint64_t sum = 0;
  for (const auto& part : parts_) sum += part->settled();
  return sum;
}

std::uint64_t Front::pushes() const {
  std::uint64_t sum = 0;
  for (const auto& part : parts_) sum += part->pushes();
  return sum;
}

}  // namespace burin
