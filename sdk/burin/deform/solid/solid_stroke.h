#pragma once
#include <burin/abi/ext/volume.h>
#include <burin/deform/evaluate/batch.h>
#include <burin/deform/evaluate/brush_stroke.h>
#include <burin/stroke/stroke_choices.h>
#include <burin/volume/solid.h>

namespace burin {

class SolidBatch;

/// The solid that a brush makes of a finished stroke: "burin.volume/1". The stroke must outlive it.
class SolidStroke {
 public:
  /// Throws Error "ID: ..." where the brush makes no solids, or reads for them what there is none of.
  explicit SolidStroke(const BrushStroke& stroke);

  /// Throws Error where the brush fails, or describes no solid.
  burin_solid_plan plan(const burin_stroke_context& context) const;

  /// What becomes of the solid unless the user says otherwise.
  SolidOperation operation(const burin_stroke_context& context) const;

  /// The solid over the nodes of one image of the stroke, in voxels of this edge, object units; for 0 of one
  /// sixth of the plan's detail or, where it is to be `merged`, of about the surface's edges down to a
  /// twelfth. Throws Error as StrokeSolid, ContractError where the brush fails, and what `progress` throws.
  StrokeSolid make(const NodeSource& source, const burin_stroke_context& context, double voxel, bool merged,
                   const Progress& progress = {}) const;

 private:
  void find_distances(SolidBatch& batch, const burin_stroke_context& context,
                      std::span<float> distances) const;

  const BrushStroke* stroke_;
  const burin_volume* volume_;
};

}  // namespace burin
