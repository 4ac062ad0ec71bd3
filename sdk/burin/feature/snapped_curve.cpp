// Puts the moved parts of a stroke and the rest together. O(n log n) for n points, with one closest point per
// point of the transitions.
#include <burin/chart/path/closed_length.h>
#include <burin/chart/path/curve_parts.h>
#include <burin/feature/snapped_curve.h>
#include <burin/stroke/curve/curve_spline.h>
#include <burin/stroke/curve/surface_curve.h>
#include <burin/surface/geometry/normals.h>
#include <burin/surface/geometry/unit_tangent.h>

#include <algorithm>
#include <optional>

namespace burin {
namespace {

/// One end of a run: the stroke beyond it is moved by a share of the offset, which falls to 0 over `reach`.
struct RunEnd {
  double t = 0;
  double beyond = 1;  ///< 1: the stroke goes on at greater t; -1: at lesser
  Vec3d offset = Vec3d::Zero();
  double reach = 0;

  double share(double at) const {
    const double away = (at - t) * beyond;
    if (!(away > 0 && away < reach)) return 0;
    const double left = 1 - away / reach;
    return left * left * (3 - 2 * left);
  }
};

/// Where and by how much the stroke's own points move.
class Transitions {
 public:
  Transitions(const SurfaceCurve& stroke, const std::vector<SnappedRun>& runs, bool whole)
      : runs_(runs), whole_(whole), period_(stroke.closed ? stroke.length() : 0) {
    if (whole) return;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      add_end(stroke, runs[i].front(), -1, gap_before(i));
      add_end(stroke, runs[i].back(), 1, gap_after(stroke, i));
    }
  }

  /// Whether a run takes the place of the stroke here.
  bool replaced(double t) const {
    return whole_ || std::ranges::any_of(runs_, [&](const SnappedRun& run) {
             return within(run, t) || (period_ > 0 && within(run, t + period_));
           });
  }

  Vec3d offset(double t) const {
    Vec3d sum = Vec3d::Zero();
    for (const RunEnd& end : ends_) {
      sum += end.share(t) * end.offset;
      if (period_ > 0) sum += (end.share(t + period_) + end.share(t - period_)) * end.offset;
    }
    return sum;
  }

 private:
  static bool within(const SnappedRun& run, double t) {
    return t >= run.front().stroke_t && t <= run.back().stroke_t;
  }

  double gap_before(std::size_t run) const {
    const double from = runs_[run].front().stroke_t;
    if (run > 0) return from - runs_[run - 1].back().stroke_t;
    return period_ > 0 ? from - (runs_.back().back().stroke_t - period_) : from;
  }

  double gap_after(const SurfaceCurve& stroke, std::size_t run) const {
    if (run + 1 < runs_.size()) return gap_before(run + 1);
    return period_ > 0 ? gap_before(0) : stroke.length() - runs_[run].back().stroke_t;
  }

  void add_end(const SurfaceCurve& stroke, const SnappedPoint& point, double beyond, double gap) {
    const Vec3d offset = point.at.position.cast<double>() - stroke_position(stroke, point.stroke_t);
    ends_.push_back({point.stroke_t, beyond, offset, std::min(2 * offset.norm(), gap)});
  }

  const std::vector<SnappedRun>& runs_;
  bool whole_;
  double period_;  ///< length of a closed stroke, 0 of an open one
  std::vector<RunEnd> ends_;
};

/// A point of the result, either one of the stroke's own or a new one.
struct Piece {
  double stroke_t;
  const CurvePoint* own;  ///< null: a new one
  SurfacePoint at;

  Vec3f position() const { return own ? own->at.position : at.position; }
};

std::vector<Piece> pieces_of(const Picker& picker, const SurfaceCurve& stroke,
                             const std::vector<SnappedRun>& runs, const Transitions& transitions) {
  std::vector<Piece> pieces;
  for (const CurvePoint& point : stroke.points) {
    if (transitions.replaced(point.t)) continue;
    const Vec3d offset = transitions.offset(point.t);
    if (offset.isZero(0)) {
      pieces.push_back({point.t, &point, point.at});
      continue;
    }
    const Vec3d wanted = point.at.position.cast<double>() + offset;
    if (const auto at = picker.closest(wanted.cast<float>(), static_cast<float>(2 * offset.norm())))
      pieces.push_back({point.t, nullptr, *at});
  }
  for (const SnappedRun& run : runs) {
    for (const SnappedPoint& point : run) {
      const bool wraps = stroke.closed && point.stroke_t >= stroke.length();
      pieces.push_back({wraps ? point.stroke_t - stroke.length() : point.stroke_t, nullptr, point.at});
    }
  }
  std::ranges::stable_sort(pieces, {}, &Piece::stroke_t);
  return pieces;
}

/// Leaves out new points that are nearer to the point before than the least step.
void thin_out(std::vector<Piece>& pieces, double least_step) {
  std::vector<Piece> kept;
  for (const Piece& piece : pieces) {
    const bool far =
        kept.empty() || static_cast<double>((piece.position() - kept.back().position()).norm()) > least_step;
    if (far || piece.own) kept.push_back(piece);
  }
  pieces.swap(kept);
}

/// The direction of the parabola through three points at the middle one, each of which may be missing.
Vec3f direction_through(const Vec3f* before, const Vec3f& at, const Vec3f* after) {
  if (!before && !after) return Vec3f::UnitX();
  if (!before) return *after - at;
  if (!after) return at - *before;
  const Vec3f in = at - *before, out = *after - at;
  const float length_in = in.norm(), length_out = out.norm();
  if (!(length_in > 0) || !(length_out > 0)) return in + out;
  return in * (length_out / length_in) + out * (length_in / length_out);
}

CurvePoint new_point(const Surface& surface, const SurfaceCurve& stroke, const Piece& piece) {
  const PenAt pen = pen_at(stroke, piece.stroke_t);
  return {.at = piece.at,
          .normal = normal_at(surface, piece.at),
          .tangent = Vec3f::Zero(),
          .time = pen.time,
          .pen = pen.pen,
          .speed = pen.speed,
          .width = pen.width};
}

/// Sets tangents of new points, and arc lengths of all.
void measure(SurfaceCurve& curve, const std::vector<Piece>& pieces) {
  const std::size_t count = curve.points.size();
  const auto position = [&](std::size_t i) { return &curve.points[i].at.position; };
  for (std::size_t i = 0; i < count; ++i) {
    if (pieces[i].own) continue;
    const Vec3f* const before = i > 0 ? position(i - 1) : curve.closed ? position(count - 1) : nullptr;
    const Vec3f* const after = i + 1 < count ? position(i + 1) : curve.closed ? position(0) : nullptr;
    CurvePoint& point = curve.points[i];
    point.tangent = unit_tangent(direction_through(before, point.at.position, after), point.normal);
  }
  const auto arc = [&](std::size_t from, std::size_t to) {
    return arc_length(curve.points[from], curve.points[to].at.position, curve.points[to].tangent);
  };
  curve.points[0].t = 0;
  for (std::size_t i = 1; i < count; ++i) curve.points[i].t = curve.points[i - 1].t + arc(i - 1, i);
  curve.closing_length = curve.closed ? arc(count - 1, 0) : 0;
}

}  // namespace

Vec3d stroke_position(const SurfaceCurve& stroke, double t) {
  if (stroke.closed) t = wrapped_t(t, stroke.length());
  const std::size_t segment = segment_at(stroke, t);
  const double begin = stroke.points[segment].t, length = stroke.segment_end(segment) - begin;
  const double share = length > 0 ? std::clamp((t - begin) / length, 0., 1.) : 0;
  const Vec3d from = stroke.points[segment].at.position.cast<double>();
  return from + share * (stroke.points[stroke.next(segment)].at.position.cast<double>() - from);
}

SnappedCurve snapped_curve(const Surface& surface, const Picker& picker, const SurfaceCurve& stroke,
                           const std::vector<SnappedRun>& runs, bool whole, double least_step) {
  const Transitions transitions(stroke, runs, whole);
  std::vector<Piece> pieces = pieces_of(picker, stroke, runs, transitions);
  thin_out(pieces, least_step);
  SnappedCurve result;
  result.curve.closed = stroke.closed;
  for (const Piece& piece : pieces) {
    result.curve.points.push_back(piece.own ? *piece.own : new_point(surface, stroke, piece));
    result.stroke_t.push_back(piece.stroke_t);
  }
  measure(result.curve, pieces);
  return result;
}

}  // namespace burin
