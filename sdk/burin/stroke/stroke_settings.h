#pragma once
#include <burin/base/vector.h>
#include <burin/stroke/dynamics.h>
#include <burin/stroke/param_setting.h>
#include <burin/stroke/pen.h>
#include <burin/stroke/stroke_choices.h>
#include <burin/stroke/symmetry.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// Least StrokeSettings::dab_spacing.
inline constexpr double least_dab_spacing = 0.01;

struct PolygonMesh;

/// A mesh in memory, or the file that it is read from.
struct MeshSource {
  std::shared_ptr<const PolygonMesh> mesh;
  std::string file;  ///< as read_mesh() takes it; read where there is no mesh

  bool given() const { return mesh || !file.empty(); }  ///< whether there is one
};

/// Meshes that a stroke bends along itself, as parts of their own beside the surface, instead of what a brush
/// does. The middle of the repeated mesh across runs over the stroke, its lowest point over the surface; half
/// its width is as wide as the stroke, wherever pen and dynamics make that narrower. The mesh at the start
/// and that at the end keep their places beside it: all three are drawn in one frame.
struct AlongSettings {
  MeshSource middle;      ///< repeated along the stroke; none: the brush draws
  MeshSource start, end;  ///< once each on strokes that are not closed; may be none
  Vec3d forward = Vec3d::UnitX(), up = Vec3d::UnitY();  ///< axes of the meshes, at right angles, that run
                                                        ///< along the stroke and over the surface
  double spacing = 0;  ///< radii from copy to copy; 0: as many whole copies as fit best, end to end
  double twist = 0;   ///< turns along the whole stroke, counter-clockwise seen along it; whole ones on closed
                      ///< strokes
  double height = 0;  ///< radii, of the lowest point over the surface

  bool given() const { return middle.given(); }  ///< whether there is a mesh to repeat
};

/// Whether triangles too large for a stroke are split before it is drawn, and how far.
struct Refining {
  enum class Kind {
    off,
    automatic,  ///< into edges of radius / fine, where the surface that the session was given has gaps of
                ///< more than radius / coarse between vertices
    edge,       ///< into edges of about this length
    error,      ///< into edges of radius / fine, and at the end into edges that represent the displacement to
                ///< this error, down to radius / finest
  };
  static constexpr double coarse = 2, fine = 16, finest = 128;
  static constexpr double least_error = 0.001, most_error = 0.5;
  Kind kind = Kind::off;
  double edge = 0;   ///< above 0, object units; of Kind::edge alone
  double error = 0;  ///< share of the greatest displacement, from least_error on; of Kind::error alone
};

/// What a stroke is drawn with. stroke/files/setting_table.h has the keys and texts of what people set.
struct StrokeSettings {
  std::string brush;    ///< id, "org.burin.groove"
  double radius = 0;    ///< object units, > 0
  double strength = 1;  ///< factor on the brush's displacement
  Cap cap = Cap::round;
  Join join = Join::round;
  std::optional<Overlap> overlap;  ///< what holds where the stroke overlaps itself; none: as the brush says
  Accumulate accumulate = Accumulate::from_base;  ///< from_current: sheets add up, whatever `overlap` says
  /// 0..1: how much of the surface's relief the stroke feels. 1: every bump. Less: what is wider than about a
  /// third of (1 - follow) radii; displacement goes along the normals of that smoother surface and adds to
  /// the relief.
  double follow = 0;
  double pressure_width = 0;  ///< 0..1, share of the width that the pen's pressure decides
  ParamSettings params;       ///< what differs from the brush's defaults
  /// What of the pen varies radius, strength and parameters; "radius" acts besides the pressure width.
  std::vector<Dynamic> dynamics;
  PenFields fields;        ///< what the pen really reports; samples that have more are refused
  std::uint64_t seed = 0;  ///< of random numbers: the brush's, and PenSource::random
  Symmetry symmetry;       ///< where else it is drawn
  double dab_spacing = 0;  ///< radii from dab to dab, for a row of dabs instead of one stroke; 0: a stroke
  bool clamp_to_radius = false;         ///< no vertex goes farther than one radius
  std::optional<SolidOperation> solid;  ///< of brushes that make solids; none: separate of those that do
                                        ///< nothing else
  double voxel = 0;  ///< edge of the solid's voxels, object units; 0: as fine as the brush's solid needs
  double blend = 0;  ///< radius of the fillet where a merged solid meets the surface, object units; 0: none
  AlongSettings along;  ///< if given, brush and params decide nothing
  Refining refining;    ///< of the surface, which gets other vertices and triangles
};

/// What a recorded stroke is drawn with: besides, how its samples become a stroke.
struct ReplaySettings : StrokeSettings {
  Closure closure = Closure::open;
  Stabilising stabilising;     ///< of the samples, before anything else sees them
  std::size_t show_every = 1;  ///< samples shown: every so many; 0: the whole stroke at its end
};

}  // namespace burin
