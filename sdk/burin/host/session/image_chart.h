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

/// The chart of a symmetric image of a stroke. If every vertex under the stroke has an image among the
/// surface's vertices, it is the image of the original's chart, so that rounding and the order of vertices
/// cannot make images differ. Otherwise it is a chart of its own. It has the slots of the chart that it
/// follows. Surface, picker and charts must outlive the object; the surface must not change.
class ImageChart {
 public:
  /// `kept` is an empty chart that receives the nodes. `radius` is that of the stroke, object units.
  ImageChart(const Surface& surface, const Picker& picker, const SymmetryInstance& image, double radius,
             LiveChart& kept)
      : surface_(&surface), picker_(&picker), image_(image), radius_(radius), live_(&kept) {}

  /// Reads the last event of the original's chart and returns whether all its vertices have images among the
  /// surface's vertices. From the first call on it must be called for every event.
  bool has_images_of(const LiveChart& original);

  /// Applies the last event of the original's chart, for which has_images_of() must have returned true.
  void reflect(const LiveChart& original);

  /// Applies the last event of the image's own chart, or all of it after reflect(); see own_is_behind().
  void copy(const LiveChart& own);

  /// The image of the original's curve: positions, normals and tangents.
  SurfaceCurve image_of(const SurfaceCurve& original) const;

  /// The image of a position.
  Vec3f moved(const Vec3f& position) const { return image_(position.cast<double>()).cast<float>(); }

  /// Whether the last event did not follow the image's own chart, so that this chart must be drawn from its
  /// start.
  bool own_is_behind() const { return followed_ != Followed::own; }
  bool reflects() const { return followed_ == Followed::original; }

  const LiveChart& live() const { return *live_; }

 private:
  enum class Followed { none, original, own };
  Vec3f turned(const Vec3f& direction) const {
    return (image_.linear * direction.cast<double>()).cast<float>();
  }
  Index image_of(Index vertex);
  void note(const LiveChart& original, Index local);
  ChartFrame reflected(const ChartFrame& frame) const;
  void begin_following(const LiveChart& chart, Followed kind);
  template <class SetSlot>
  void follow(const LiveChart& chart, Followed kind, const SetSlot& set_slot);

  const Surface* surface_;
  const Picker* picker_;
  SymmetryInstance image_;
  double radius_;
  LiveChart* live_;
  Followed followed_ = Followed::none;
  std::vector<Index> images_;        ///< [local index in the original's chart] image vertex, or no_index
  std::unordered_set<Index> taken_;  ///< vertices that are the image of a vertex
  std::set<Index> without_image_;    ///< local indices of vertices with nodes but without an image
  bool seen_ = false;                ///< has_images_of() was called
};

}  // namespace burin
