#pragma once
#include <burin/chart/chart_options.h>
#include <burin/chart/joins/bends.h>
#include <burin/chart/joins/joins.h>
#include <burin/chart/path/stroke_samples.h>

#include <optional>
#include <span>
#include <vector>

namespace burin {

/// A part of the stroke that is charted as a stroke of its own.
struct Leg {
  double begin = 0, end = 0;  ///< arc lengths on the stroke, object units
  Extensions reach;           ///< how far it continues beyond them, around smooth and mitered corners
  bool operator==(const Leg&) const = default;
};

/// A corner as one of its two legs meets it.
struct LegEnd {
  Corner corner;
  Index cut;        ///< index of the corner
  bool first_leg;   ///< the corner ends the leg; otherwise it begins the leg
  Index other_leg;  ///< index of the other leg at the corner
  bool continued;   ///< the legs are charted beyond the corner
};

/// The corners at both ends of a leg, where it does not end with the stroke.
struct LegEnds {
  std::optional<LegEnd> before, after;
};

/// A bend with the way before and after its middle over which a smooth join spreads t, object units.
struct SpreadBend {
  Bend bend;
  double span;
  bool operator==(const SpreadBend&) const = default;
};

/// Where a stroke is cut into legs, which its joins require: at its corners, and for Overlap also at bends
/// that are too long to be corners. Strokes with round joins, and strokes without bends, are one leg.
class StrokeLegs {
 public:
  /// `charted_radius` is the half width of the legs' charts at width 1, object units, at least that of the
  /// stroke.
  StrokeLegs(const ChartOptions& options, double charted_radius)
      : options_(options), charted_radius_(charted_radius) {}

  /// Cuts another curve, whose first `unchanged` points are those of the last call. Returns the arc length
  /// below which joins make the same of the same nodes as with the curve before; minus infinity on closed
  /// strokes and without unchanged points.
  double update(const SurfaceCurve& curve, std::size_t unchanged);

  /// The legs in the order of t. On a closed stroke with corners the last one ends beyond the length.
  std::span<const Leg> legs() const { return legs_; }
  /// [leg]
  std::span<const LegEnds> ends() const { return ends_; }

  /// The bends between the legs, in the order of t.
  std::span<const SpreadBend> cuts() const { return cuts_; }
  /// The bend at a cut as a part of the stroke. On a closed stroke it may end beyond the length.
  Leg bend(std::size_t cut) const {
    const double loop = cuts_[cut].bend.begin < 0 ? length_ : 0;
    return {cuts_[cut].bend.begin + loop, cuts_[cut].bend.end + loop, {}};
  }
  /// The bends at which the stroke is not cut and over whose spans t may lie: on an open stroke at most one,
  /// since spans do not overlap; on a closed one, where t counts modulo the length, all.
  std::span<const SpreadBend> uncut_around(double t) const;

  const StrokeBends& bends() const { return bends_; }
  bool closed() const { return closed_; }
  double length() const { return length_; }  ///< of the stroke, object units

 private:
  void find_cuts(const SurfaceCurve& curve);
  bool is_corner(const Bend& bend) const;
  bool is_cut(const Bend& bend) const;
  Corner corner_at(const SurfaceCurve& curve, const SpreadBend& cut, double loop) const;
  double span(std::size_t bend) const;
  double reach(double turn) const;
  LegEnds ends_of(std::size_t leg) const;
  void add_leg(double begin, double end);

  ChartOptions options_;
  double charted_radius_;
  double length_ = 0;
  bool closed_ = false;
  StrokeBends bends_;
  std::vector<SpreadBend> cuts_, uncut_;
  std::vector<Corner> corners_;  ///< [i] the corner at cuts_[i]
  std::vector<Leg> legs_;
  std::vector<LegEnds> ends_;
};

}  // namespace burin
