#pragma once
#include <burin/chart/live_chart.h>
#include <burin/stroke/curve/surface_curve.h>
#include <burin/stroke/symmetry.h>
#include <burin/surface/picker.h>
#include <burin/surface/surface.h>

#include <set>
#include <unordered_set>
#include <vector>

namespace burin {

/// The chart of a symmetric image of a stroke. Where the surface has the symmetry, vertex for vertex, it is
/// the image of the original's chart: what the rounding of places or the order of vertices decides is decided
/// once, for all images. Elsewhere it is a chart of the image's own. Slots are those of the chart that it
/// follows. Surface, picker and charts must outlive it; the surface stays as it is.
class ImageChart {
 public:
  /// `kept`: where the chart is to be, without nodes yet. `radius`: of the stroke, object units.
  ImageChart(const Surface& surface, const Picker& picker, const SymmetryInstance& image, double radius,
             LiveChart& kept)
      : surface_(&surface), picker_(&picker), image_(image), radius_(radius), live_(&kept) {}

  /// Looks at the last event of the original's chart, all of whose events must be shown in turn from the
  /// first that is. Whether all its vertices have images among the surface's.
  bool has_images_of(const LiveChart& original);

  /// Follows the last event of the original's chart, which has_images_of() saw.
  void reflect(const LiveChart& original);

  /// Follows the last event of the image's own chart, or all of it after reflect(); own_is_behind() says so.
  void copy(const LiveChart& own);

  /// The image of the original's curve: its points and normals.
  SurfaceCurve image_of(const SurfaceCurve& original) const;

  /// Whether the image's own chart was not followed last, so that it has to be drawn from its begin.
  bool own_is_behind() const { return followed_ != Followed::own; }
  bool reflects() const { return followed_ == Followed::original; }

  const LiveChart& live() const { return *live_; }

 private:
  enum class Followed { none, original, own };
  Vec3f moved(const Vec3f& place) const { return image_(place.cast<double>()).cast<float>(); }
  Vec3f turned(const Vec3f& direction) const {
    return (image_.linear * direction.cast<double>()).cast<float>();
  }
  Index image_of(Index vertex);
  void note(const LiveChart& original, Index place);
  ChartFrame reflected(const ChartFrame& frame) const;
  void begin_following(const LiveChart& chart, Followed kind);
  template <class Place>
  void follow(const LiveChart& chart, Followed kind, const Place& place);

  const Surface* surface_;
  const Picker* picker_;
  SymmetryInstance image_;
  double radius_;
  LiveChart* live_;
  Followed followed_ = Followed::none;
  std::vector<Index> images_;        ///< [place of the original's chart] vertex; no_index: there is none
  std::unordered_set<Index> taken_;  ///< images, each of one vertex
  std::set<Index> without_image_;    ///< places of the original's chart that have nodes
  bool seen_ = false;                ///< has_images_of() was asked
};

}  // namespace burin
