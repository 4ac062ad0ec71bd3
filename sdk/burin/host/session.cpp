// Every public function of Session forwards to Impl. Functions that can fail run inside Impl::guarded(),
// which resets the cost and the list of changed vertices and drops the open stroke if anything throws.
#include <burin/abi/plugin.h>
#include <burin/base/error.h>
#include <burin/base/stopwatch.h>
#include <burin/deform/evaluate/plugin_call.h>
#include <burin/host/session.h>
#include <burin/host/session/carry_state.h>
#include <burin/host/session/merged_surface.h>
#include <burin/host/session/no_brush.h>
#include <burin/host/session/open_stroke.h>
#include <burin/host/session/sculpted_surface.h>

#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace burin {

namespace {

/// A brush that a session has made. Its descriptor is another one once its module was loaded anew.
struct CreatedBrush {
  const burin_brush_descriptor* descriptor = nullptr;
  BrushPtr brush;
};

/// What strokes made of one kind, in their order, and what those made that were undone, the last one first.
template <class Thing>
struct Made {
  std::vector<Thing> there, undone;

  void take(Turn turn) {
    auto [from, to] = turn == Turn::undo ? std::tie(there, undone) : std::tie(undone, there);
    to.push_back(std::move(from.back()));
    from.pop_back();
  }
};

}  // namespace

struct Session::Impl {
  Impl(Surface given, const BrushLibrary& library, SolidMerger solid_merger)
      : surface(std::move(given)), brushes(&library), merger(std::move(solid_merger)) {}

  const burin_brush& brush(const BrushEntry& entry);
  OpenStroke& open_stroke();
  StrokeEvent draw(const std::optional<CurveGround::Point>& at, double time, const Pen& pen, Show show,
                   StageClock& clock);
  OpenStroke& stroke_for_sample();
  std::span<const Index> finish_piece(Closure closure);
  std::span<const Index> finish(Closure closure);
  std::span<const Index> apply(const VertexMoves& moves);
  MadePart add_part();
  void merge_solid(const SolidMerge& merge);
  void end_redoing();
  void drop();
  bool take(Turn turn);
  bool take_unless_open(Turn turn);

  /// Runs `body`. If it throws, the open stroke is dropped, and the surface is as before the stroke.
  template <class Body>
  auto guarded(const Body& body) {
    cost = {};
    surface.clear_changed();
    sorted_chart.reset();
    try {
      return body();
    } catch (...) {
      drop();
      throw;
    }
  }

  SculptedSurface surface;
  const BrushLibrary* brushes;
  std::map<std::string, CreatedBrush, std::less<>> created;  ///< by id
  Evaluator evaluator;
  std::optional<OpenStroke> stroke;
  std::optional<Chart> sorted_chart;     ///< sorted copy of last_live, made on request
  const LiveChart* last_live = nullptr;  ///< chart of the open stroke, or of the last one
  SurfaceCurve last_curve;
  Made<StrokeSolid> parts;
  SolidMerger merger;
  Progress progress;
  Made<MergeReport> merges;
  std::vector<std::string> warnings;  ///< of finished strokes
  Made<TriangleMesh> bent_meshes;
  EventCost cost;
};

const burin_brush& Session::Impl::brush(const BrushEntry& entry) {
  CreatedBrush& kept = created[entry.descriptor->id];
  if (kept.descriptor == entry.descriptor) return *kept.brush;
  BrushPtr brush = brushes->create(entry);
  if (kept.brush) {
    const PluginCall call("brush", entry.descriptor->id);
    if (const std::string lost = carry_state(*kept.brush, *brush); !lost.empty())
      warnings.push_back(std::string(entry.descriptor->id) + ": " + lost);
  }
  kept = {entry.descriptor, std::move(brush)};
  return *kept.brush;
}

OpenStroke& Session::Impl::open_stroke() {
  if (!stroke) throw ContractError("no stroke is open");
  return *stroke;
}

/// The open stroke; starts a new piece if the previous one has ended.
OpenStroke& Session::Impl::stroke_for_sample() {
  if (!open_stroke().piece_kept()) return *stroke;
  stroke->begin_piece();
  last_live = &stroke->live();
  return *stroke;
}

StrokeEvent Session::Impl::draw(const std::optional<CurveGround::Point>& at, double time, const Pen& pen,
                                Show show, StageClock& clock) {
  clock.lap(Stage::pick);
  if (!at) return {StrokeEvent::Outcome::off_surface, {}};
  if (!stroke->connects(*at)) return {StrokeEvent::Outcome::disconnected, {}};
  stroke->trace(*at, time, pen);
  clock.lap(Stage::curve);
  if (show == Show::later) return {StrokeEvent::Outcome::drawn, {}};
  const std::span<const Index> seen =
      apply(stroke->draw({evaluator, surface.paint().base(), cost, clock, progress}));
  clock.lap(Stage::move);
  return {StrokeEvent::Outcome::drawn, seen};
}

std::span<const Index> Session::Impl::apply(const VertexMoves& moves) {
  cost.moved = moves.vertices.size();
  surface.show(moves);
  return surface.changed();
}

/// Finishes the current piece, unless it is empty or kept.
std::span<const Index> Session::Impl::finish_piece(Closure closure) {
  if (stroke->piece_empty() || stroke->piece_kept()) return surface.changed();
  StageClock clock(cost);
  apply(stroke->finish(closure, {evaluator, surface.paint().base(), cost, clock, progress}));
  last_curve = stroke->curve();
  clock.lap(Stage::move);
  return surface.changed();
}

std::span<const Index> Session::Impl::finish(Closure closure) {
  if (open_stroke().empty()) {
    stroke.reset();
    return {};
  }
  finish_piece(closure);
  warnings.insert(warnings.end(), stroke->warnings().begin(), stroke->warnings().end());
  StageClock clock(cost);
  if (std::optional<SolidMerge> merge = stroke->merge()) {
    merge->progress = progress;
    merge_solid(*merge);
    end_redoing();
    clock.lap(Stage::record);
    return surface.changed();
  }
  surface.keep(add_part());
  end_redoing();
  stroke.reset();
  clock.lap(Stage::record);
  return surface.changed();
}

/// What the stroke made, if anything.
MadePart Session::Impl::add_part() {
  if (stroke->bent()) {
    bent_meshes.there.push_back(std::move(*stroke->bent()));
    return MadePart::mesh;
  }
  std::optional<StrokeSolid>& solid = stroke->solid();
  if (!solid || solid->empty()) return MadePart::none;
  parts.there.push_back(std::move(*solid));
  return MadePart::solid;
}

/// What was undone is gone once another stroke is finished.
void Session::Impl::end_redoing() {
  parts.undone.clear();
  merges.undone.clear();
  bent_meshes.undone.clear();
}

/// Merges what the stroke made with the surface. The stroke is gone then.
void Session::Impl::merge_solid(const SolidMerge& merge) {
  if (!merger) throw Error("this application cannot merge solids with the surface");
  const MergedSolid merged = merger(merge);
  // The last time: from here on the surface is replaced.
  report(progress, "rebuilding the surface", 0);
  Stopwatch watch;
  PaintedSurface made = with_patch(surface.base(), surface.picker(), surface.paint().base(), merged.patch);
  MergeReport report = report_of(merged, surface.base(), made.surface);
  report.solid_seconds = stroke->solid_seconds();
  stroke.reset();
  last_live = nullptr;
  surface.replace(std::move(made));
  report.rebuild_seconds = watch.lap();
  merges.there.push_back(report);
}

void Session::Impl::drop() {
  if (!stroke) return;
  surface.drop();
  stroke.reset();
}

/// Undoes the last step, or makes the last undone one again; returns false if there is none.
bool Session::Impl::take(Turn turn) {
  std::optional<UndoStep> step = surface.take_step(turn);
  if (!step) return false;
  StageClock clock(cost);
  if (step->surface) {
    last_live = nullptr;
    merges.take(turn);
  } else {
    surface.show(*step);
    cost.moved = step->vertices.size();
    clock.lap(Stage::move);
    if (step->made == MadePart::solid) parts.take(turn);
    if (step->made == MadePart::mesh) bent_meshes.take(turn);
  }
  surface.restore(std::move(*step), turn);
  clock.lap(Stage::record);
  return true;
}

Session::Session(Surface surface, const BrushLibrary& brushes, SolidMerger merger) {
  if (surface.is_point_set()) throw ContractError("a point set cannot be sculpted");
  impl_ = std::make_unique<Impl>(std::move(surface), brushes, std::move(merger));
}
Session::~Session() = default;
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

const Surface& Session::surface() const { return impl_->surface.base(); }
const Picker& Session::picker() const { return impl_->surface.picker(); }
std::span<const Vec3f> Session::positions() const { return impl_->surface.shown().positions(); }
std::span<const Vec3f> Session::normals() const { return impl_->surface.shown().normals(); }
std::uint64_t Session::generation() const { return impl_->surface.generation(); }
void Session::set_progress(Progress progress) { impl_->progress = std::move(progress); }

std::span<const StrokeSolid> Session::parts() const { return impl_->parts.there; }
std::span<const MergeReport> Session::merges() const { return impl_->merges.there; }
std::span<const std::string> Session::warnings() const { return impl_->warnings; }
std::span<const TriangleMesh> Session::bent_meshes() const { return impl_->bent_meshes.there; }
const Paint& Session::paint() const { return impl_->surface.paint().shown(); }

void Session::set_paint(Paint paint) {
  impl_->guarded([&] {
    if (impl_->stroke) throw ContractError("a stroke is open");
    impl_->surface.set_paint(std::move(paint));
  });
}

void Session::move_vertices(std::span<const Index> vertices, std::span<const Vec3f> positions) {
  impl_->guarded([&] {
    if (impl_->stroke) throw ContractError("a stroke is open");
    impl_->surface.move(vertices, positions);
  });
}

void Session::begin_stroke(const StrokeSettings& settings) {
  impl_->guarded([&] {
    if (impl_->stroke) throw ContractError("a stroke is open already");
    const BrushEntry* entry = settings.along.given() ? nullptr : &impl_->brushes->find(settings.brush);
    const burin_brush_descriptor& descriptor = entry ? *entry->descriptor : no_brush_descriptor();
    SculptedSurface& surface = impl_->surface;
    impl_->stroke.emplace(surface.base(), surface.picker(), surface.builders(),
                          entry ? impl_->brush(*entry) : no_brush(), descriptor, settings);
    impl_->last_live = &impl_->stroke->live();
    surface.prepare_paint(descriptor.outputs_written);
  });
}

StrokeEvent Session::add_sample(const Ray& ray, double time, const Pen& pen, Show show) {
  return impl_->guarded([&] {
    const CurveGround& ground = impl_->stroke_for_sample().ground();
    StageClock clock(impl_->cost);
    return impl_->draw(ground.pick(ray), time, pen, show, clock);
  });
}

StrokeEvent Session::add_sample(const Vec3d& position, double time, const Pen& pen, Show show) {
  return impl_->guarded([&] {
    const OpenStroke& stroke = impl_->stroke_for_sample();
    StageClock clock(impl_->cost);
    const auto reach = static_cast<float>(stroke.radius());
    return impl_->draw(stroke.ground().closest(position.cast<float>(), reach), time, pen, show, clock);
  });
}

std::span<const Index> Session::end_piece(Closure closure) {
  return impl_->guarded([&] {
    OpenStroke& stroke = impl_->open_stroke();
    const std::span<const Index> seen = impl_->finish_piece(closure);
    if (!stroke.piece_empty() && !stroke.piece_kept()) stroke.keep_piece();
    return seen;
  });
}

std::span<const Index> Session::end_stroke(Closure closure) {
  return impl_->guarded([&] { return impl_->finish(closure); });
}

void Session::cancel_stroke() {
  impl_->surface.clear_changed();
  impl_->drop();
}

std::span<const Index> Session::changed() const { return impl_->surface.changed(); }

const Chart& Session::chart() const {
  if (!impl_->sorted_chart) impl_->sorted_chart = impl_->last_live ? impl_->last_live->sorted() : Chart{};
  return *impl_->sorted_chart;
}
const SurfaceCurve& Session::curve() const {
  return impl_->stroke ? impl_->stroke->curve() : impl_->last_curve;
}

bool Session::Impl::take_unless_open(Turn turn) {
  return guarded([&] {
    if (stroke) throw ContractError("a stroke is open");
    return take(turn);
  });
}

bool Session::undo() { return impl_->take_unless_open(Turn::undo); }
bool Session::redo() { return impl_->take_unless_open(Turn::redo); }
std::size_t Session::undo_count() const { return impl_->surface.step_count(Turn::undo); }
std::size_t Session::redo_count() const { return impl_->surface.step_count(Turn::redo); }
void Session::limit_undo(std::size_t bytes) { impl_->surface.limit_undo(bytes); }
std::size_t Session::undo_bytes() const { return impl_->surface.undo_bytes(); }

const EventCost& Session::cost() const { return impl_->cost; }

}  // namespace burin
