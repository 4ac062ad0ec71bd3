// Combines the sheets of each vertex to one position and one tint. Costs O(1) per vertex with one sheet, and
// about O(s log s) for s sheets (O(s^2) for Overlap::max and min), on all threads.
#include <burin/base/parallel.h>
#include <burin/deform/blend/blend.h>
#include <burin/deform/blend/combine_sheets.h>
#include <burin/deform/evaluate/first_failure.h>

namespace burin {
namespace {

Vec3f unlimited_position(const Vec3f& base, const VertexSheets& sheets, const BlendOptions& options) {
  if (sheets.count() == 0) return base;
  if (sheets.count() == 1) return sheets.alone_moved(base);
  const Vec3d move = combined_move(sheets.all(), options.overlap, options.radius);
  if (move.isZero(0)) return base;
  return (base.cast<double>() + move).cast<float>();
}

Vec3f blended_position(const Vec3f& base, const VertexSheets& sheets, const BlendOptions& options) {
  Vec3f free = unlimited_position(base, sheets, options);
  const double distance = (free - base).cast<double>().norm();
  if (!(distance > options.limit)) return free;
  return base + static_cast<float>(options.limit / distance) * (free - base);
}

Tint blended_tint(const Tint& before, const VertexSheets& sheets, const BlendOptions& options) {
  if (sheets.count() == 0) return before;
  if (sheets.count() == 1) return sheets.alone_tint();
  return combined_tint(sheets.all(), options.overlap, before);
}

}  // namespace

void blend_sheets(const Surface& surface, const StrokeSheets& stroke, std::span<const Index> vertices,
                  const BlendOptions& options, std::string_view brush, std::span<Vec3f> positions) {
  FirstFailure failure;
  parallel_blocks(vertices.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const VertexSheets sheets(stroke, options.radius, vertices[i]);
      positions[i] = blended_position(surface.positions[vertices[i]], sheets, options);
      if (!positions[i].allFinite()) return failure.note(i, "displaces beyond the range of floats");
    }
  });
  if (!failure.any()) return;
  VertexSheets(stroke, options.radius, vertices[failure.element()])
      .for_each_node([&](std::uint32_t image, Index slot) {
        failure.throw_at(brush, stroke.instances[image].chart->nodes(), slot);
      });
}

void blend_tints(const Paint& paint, const StrokeSheets& stroke, std::span<const Index> vertices,
                 const BlendOptions& options, std::span<Tint> tints) {
  parallel_blocks(vertices.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Tint before = tint_of(paint.colour_of(vertices[i]), paint.mask_of(vertices[i]));
      tints[i] = blended_tint(before, VertexSheets(stroke, options.radius, vertices[i]), options);
    }
  });
}

}  // namespace burin
