// Draws one stroke of a brush on a plane, whose nodes are then evaluated again and again.
#include "bench_brush/drawn_stroke.h"

#include <burin/abi/brush.h>
#include <burin/host/session.h>
#include <burin/level_set/solid_mesh.h>
#include <burin/services/stamp_services.h>

#include <cmath>

#include "input/grid_mesh.h"
#include "options/view.h"
#include "pictures/result_picture.h"
#include "system/console.h"

namespace burin {
namespace {

constexpr double radius = 0.12;

/// The square from -1 to 1 in x and y.
TriangleMesh plane() {
  constexpr Index quads = 212;
  return grid_mesh(quads, quads,
                   [](double u, double v) { return Vec3f(static_cast<float>(u), static_cast<float>(v), 0); });
}

StrokeSettings settings_of(const burin_brush_descriptor& brush, const std::filesystem::path& stamp) {
  StrokeSettings settings;
  settings.brush = brush.id;
  settings.radius = radius;
  for (std::uint32_t i = 0; i < brush.param_count; ++i)
    if (brush.params[i]->type == BURIN_PARAM_FILE && !brush.params[i]->default_file)
      settings.params[brush.params[i]->id] = stamp.string();
  return settings;
}

/// Draws an S; returns the cost of all events.
EventCost draw(Session& session, const StrokeSettings& settings) {
  constexpr int samples = 80;
  EventCost cost;
  session.begin_stroke(settings);
  for (int i = 0; i < samples; ++i) {
    const double along = 1.6 * i / (samples - 1) - 0.8;
    session.add_sample(Vec3d(along, 0.4 * std::sin(4 * along), 0), 0.004 * i, {});
    cost += session.cost();
  }
  session.end_stroke();
  cost += session.cost();
  return cost;
}

}  // namespace

DrawnStroke draw_stroke(const std::filesystem::path& module, const std::string& brush,
                        const std::filesystem::path& stamp) {
  BrushLibrary brushes(log_on_console, stamp_services(read_vdb));
  brushes.load(module);
  Session session(make_surface(plane()), brushes, merge_solid);
  const EventCost cost = draw(session, settings_of(*brushes.find(brush).descriptor, stamp));
  const SurfaceCurve curve = session.curve();
  ViewOptions view;
  view.direction = Vec3d(0.2, 0.7, -1);
  const Camera camera = stroke_view(session.surface(), {&curve, 1}, radius, view);
  return {cost.seconds[static_cast<std::size_t>(Stage::evaluate)] / cost.total(),
          draw_result(session, part_meshes(session), camera)};
}

}  // namespace burin
