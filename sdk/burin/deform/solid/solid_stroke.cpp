#include <burin/base/error.h>
#include <burin/deform/evaluate/error_text.h>
#include <burin/deform/solid/solid_batch.h>
#include <burin/deform/solid/solid_stroke.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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
  return plan;
}

StrokeSolid SolidStroke::make(const NodeSource& source, const burin_stroke_context& context, double voxel,
                              const Progress& progress) const {
  constexpr double voxels_over_detail = 6;
  const burin_solid_plan made = plan(context);
  const std::vector<Index> slots = source.nodes.live().sorted_slots();
  const Chart chart = source.nodes.live().sorted();
  const SolidGround ground{source.surface, chart, [&](Index vertex) { return source.base_place(vertex); }};
  const SolidExtent extent{.h_min = made.h_min,
                           .h_max = made.h_max,
                           .radius = static_cast<double>(source.radius),
                           .voxel = voxel > 0 ? voxel : made.detail / voxels_over_detail};
  try {
    return StrokeSolid(ground, extent, distance(source, context, slots), progress);
  } catch (const ContractError&) {
    throw;
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", stroke_->descriptor().id, error.what()));
  }
}

DistanceToSolid SolidStroke::distance(const NodeSource& source, const burin_stroke_context& context,
                                      std::span<const Index> slots) const {
  return [this, &source, &context, slots](std::span<const ShellPoint> points, std::span<float> distances) {
    thread_local SolidBatch batch;
    const std::uint64_t inputs = stroke_->descriptor().inputs_read;
    for (std::size_t begin = 0; begin < points.size(); begin += SolidBatch::capacity) {
      const auto part = points.subspan(begin, std::min(SolidBatch::capacity, points.size() - begin));
      batch.fill(source, inputs, stroke_->params(), part, slots);
      ErrorText error;
      const PluginCall call("brush", stroke_->descriptor().id);
      const burin_status status =
          volume_->distance(stroke_->brush(), stroke_->handle(), &context, &batch.inputs(), batch.heights(),
                            batch.distances(), error.abi());
      if (status != BURIN_OK)
        throw ContractError(fmt::format("{}: {}", stroke_->descriptor().id, error.line(status)));
      std::ranges::copy(batch.written(), distances.begin() + static_cast<std::ptrdiff_t>(begin));
    }
  };
}

}  // namespace burin
