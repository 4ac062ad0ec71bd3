#pragma once
#include <burin/host/brush_library.h>
#include <burin/host/c/burin.h>
#include <burin/stroke/recording.h>
#include <burin/stroke/stabiliser.h>
#include <burin/stroke/stroke_settings.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace burin::c {

/// A sample of the pen near the surface, or where a ray meets it.
struct PenSample {
  Sample sample;                    ///< position: where the ray begins, if there is one
  Vec3d direction = Vec3d::Zero();  ///< of the ray; zero: there is none

  bool is_ray() const { return !direction.isZero(0); }
  Ray ray() const { return {sample.position.cast<float>(), direction.cast<float>()}; }
};

/// Reads how a stroke is drawn. Throws plugin::Error for what burin_stroke does not allow, with
/// BURIN_NOT_FOUND if there is no such brush.
ReplaySettings stroke_settings(const burin_stroke* given, const BrushLibrary& brushes, bool may_refine);

/// The pen of an open stroke: checks its samples, and smooths them.
class PenInput {
 public:
  explicit PenInput(const ReplaySettings& settings)
      : fields_(settings.fields),
        smooths_(settings.stabilising.kind != Stabilising::Kind::none),
        stabiliser_(settings.stabilising) {}

  /// Reads samples. Throws plugin::Error for one that burin_sample does not allow; nothing changes then.
  std::vector<PenSample> read(const burin_sample* samples, std::uint64_t count) const;

  /// Takes a sample that was read; returns what is to be drawn.
  PenSample take(const PenSample& given);

  /// What is to be drawn at the end of the stroke.
  std::optional<PenSample> finish() const;

 private:
  void check(const PenSample& given, std::uint64_t number, double last_time) const;

  PenFields fields_;
  bool smooths_;
  Stabiliser stabiliser_;
  std::optional<double> last_time_;  ///< of the samples so far
};

/// The samples that a stroke will have, as far as the caller tells, as they will be drawn; none for a stroke
/// that does not refine the surface. Throws plugin::Error for one that burin_sample does not allow.
std::vector<PenSample> path_of(const burin_stroke& given, const ReplaySettings& settings);

}  // namespace burin::c
