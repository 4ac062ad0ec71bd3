// Makes the solid of a finished stroke with a brush: asks for its plan, then for distances in batches of up
// to 1024 points, and checks both.
#include <burin/base/error.h>
#include <burin/chart/chart_triangles.h>
#include <burin/deform/evaluate/error_text.h>
#include <burin/deform/evaluate/object_pool.h>
#include <burin/deform/solid/solid_batch.h>
#include <burin/deform/solid/solid_stroke.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace burin {

SolidStroke::SolidStroke(const BrushStroke& stroke)
    : stroke_(&stroke), volume_(static_cast<const burin_volume*>(stroke.extension(BURIN_EXT_VOLUME))) {
  const char* id = stroke.descriptor().id;
  if (!volume_ || !BURIN_HAS(volume_, burin_volume, distance))
    throw Error(fmt::format("{}: makes no solids", id));
  if (stroke.descriptor().inputs_read & ~SolidBatch::inputs_offered)
    throw Error(fmt::format("{}: reads inputs that solids do not have", id));
}

burin_solid_plan SolidStroke::plan(const burin_stroke_context& context) const {
  const char* id = stroke_->descriptor().id;
  burin_solid_plan plan{};
  plan.struct_size = sizeof(burin_solid_plan);
  ErrorText error;
  const PluginCall call("brush", id);
  const burin_status status =
      volume_->plan(stroke_->brush(), stroke_->handle(), &context, &stroke_->params(), &plan, error.abi());
  if (status != BURIN_OK) throw Error(fmt::format("{}: {}", id, error.line(status)));
  const bool finite = std::isfinite(plan.h_min) && std::isfinite(plan.h_max) && std::isfinite(plan.detail);
  if (!finite || !(plan.h_min < plan.h_max) || !(plan.detail > 0))
    throw ContractError(fmt::format("{}: asked for a solid from h {} to {} of a detail of {}", id, plan.h_min,
                                    plan.h_max, plan.detail));
  if (plan.operation > BURIN_SOLID_INTERSECTION)
    throw ContractError(
        fmt::format("{}: asked for the unknown operation {} with its solid", id, plan.operation));
  return plan;
}

SolidOperation SolidStroke::operation(const burin_stroke_context& context) const {
  switch (plan(context).operation) {
    case BURIN_SOLID_UNION:
      return SolidOperation::unite;
    case BURIN_SOLID_DIFFERENCE:
      return SolidOperation::difference;
    case BURIN_SOLID_INTERSECTION:
      return SolidOperation::intersection;
    default:
      return SolidOperation::separate;
  }
}

namespace {

/// The mean edge of the base surface's triangles in the chart, object units.
double mean_edge(const SolidGround& ground) {
  double sum = 0;
  std::size_t count = 0;
  for (const ChartTriangle& triangle : chart_triangles(ground.surface, ground.chart))
    for (std::size_t i = 0; i < 3; ++i, ++count) {
      const auto place = [&](std::size_t k) {
        return ground.position(ground.chart.vertex[triangle.nodes[k % 3]]);
      };
      sum += static_cast<double>((place(i + 1) - place(i)).norm());
    }
  return count > 0 ? sum / static_cast<double>(count) : 0;
}

double voxel_for(double detail, const SolidGround& ground, bool merged) {
  constexpr double most = 6, finest = 12;  // voxels over the detail
  if (!merged) return detail / most;
  return std::clamp(mean_edge(ground), detail / finest, detail / most);
}

}  // namespace

StrokeSolid SolidStroke::make(const NodeSource& source, const burin_stroke_context& context, double voxel,
                              bool merged, const Progress& progress) const {
  const burin_solid_plan made = plan(context);
  const LiveChart& live = source.nodes.live();
  const std::vector<Index> slots = live.sorted_slots();
  const Chart chart = live.chart_of(slots);
  const SolidGround ground{source.surface, chart, [&](Index vertex) { return source.base_position(vertex); }};
  const SolidExtent extent{.h_min = made.h_min,
                           .h_max = made.h_max,
                           .radius = static_cast<double>(source.radius),
                           .voxel = voxel > 0 ? voxel : voxel_for(made.detail, ground, merged)};
  ObjectPool<SolidBatch> pool;
  const auto distance = [&](std::span<const ShellPoint> points, std::span<float> distances) {
    std::unique_ptr<SolidBatch> batch = pool.take();
    for (std::size_t begin = 0; begin < points.size(); begin += SolidBatch::capacity) {
      const std::size_t count = std::min(SolidBatch::capacity, points.size() - begin);
      batch->fill(source, stroke_->descriptor().inputs_read, stroke_->params(), points.subspan(begin, count),
                  slots);
      find_distances(*batch, context, distances.subspan(begin, count));
    }
    pool.give_back(std::move(batch));
  };
  try {
    return StrokeSolid(ground, extent, distance, progress);
  } catch (const ContractError&) {
    throw;
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", stroke_->descriptor().id, error.what()));
  }
}

/// The brush's, of the points that the batch is filled with.
void SolidStroke::find_distances(SolidBatch& batch, const burin_stroke_context& context,
                                 std::span<float> distances) const {
  const char* id = stroke_->descriptor().id;
  ErrorText error;
  const PluginCall call("brush", id);
  const burin_status status =
      volume_->distance(stroke_->brush(), stroke_->handle(), &context, &batch.inputs(), batch.heights(),
                        batch.distances(), error.abi());
  if (status != BURIN_OK) throw ContractError(fmt::format("{}: {}", id, error.line(status)));
  std::ranges::copy(batch.written(), distances.begin());
}

}  // namespace burin
