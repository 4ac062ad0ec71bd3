// Every public function of Session forwards to Impl. Functions that can fail run inside Impl::guarded(),
// which resets the cost and the list of changed vertices and drops the open stroke if anything throws.
#include <burin/abi/plugin.h>
#include <burin/base/error.h>
#include <burin/base/hash.h>
#include <burin/base/stopwatch.h>
#include <burin/deform/evaluate/plugin_call.h>
#include <burin/deform/shown/shown_paint.h>
#include <burin/deform/shown/shown_surface.h>
#include <burin/deform/shown/undo_journal.h>
#include <burin/host/session.h>
#include <burin/host/session/carry_state.h>
#include <burin/host/session/merged_surface.h>
#include <burin/host/session/no_brush.h>
#include <burin/host/session/open_stroke.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

namespace burin {

namespace {

/// A brush that a session has made. Its descriptor is another one once its module was loaded anew.
struct CreatedBrush {
  const burin_brush_descriptor* descriptor = nullptr;
  BrushPtr brush;
};

}  // namespace

struct Session::Impl {
  Impl(Surface given, const BrushLibrary& library, SolidMerger solid_merger)
      : surface(std::move(given)),
        picker(surface),
        builders(std::make_unique<ChartBuilders>(surface, picker)),
        shown(surface),
        paint(surface.vertex_count()),
        brushes(&library),
        merger(std::move(solid_merger)) {}

  const burin_brush& brush(const BrushEntry& entry);
  OpenStroke& open_stroke();
  StrokeEvent draw(const std::optional<CurveGround::Point>& at, double time, const Pen& pen, Show show,
                   StageClock& clock);
  void set_paint(Paint given);
  OpenStroke& stroke_for_sample();
  std::span<const Index> finish_piece(Closure closure);
  std::span<const Index> finish(Closure closure);
  std::span<const Index> apply(const VertexMoves& moves);
  std::span<const Index> note_changed(std::span<const Index> moved, std::span<const Index> painted);
  void commit(std::span<const Index> displaced);
  MadePart add_part();
  void merge_solid(const SolidMerge& merge);
  void replace_surface(Surface made, Paint painted);
  void restore_surface(Surface before, Paint painted);
  void drop();

  /// Runs `body`. If it throws, the open stroke is dropped, and the surface is as before the stroke.
  template <class Body>
  auto guarded(const Body& body) {
    cost = {};
    changed.clear();
    sorted_chart.reset();
    try {
      return body();
    } catch (...) {
      drop();
      throw;
    }
  }

  Surface surface;
  Picker picker;
  std::unique_ptr<ChartBuilders> builders;
  /// Of the surfaces that merges replaced: made anew after undo they would have other clusters.
  std::vector<std::unique_ptr<ChartBuilders>> replaced_builders;
  ShownSurface shown;
  ShownPaint paint;
  const BrushLibrary* brushes;
  std::map<std::string, CreatedBrush, std::less<>> created;  ///< by id
  Evaluator evaluator;
  std::optional<OpenStroke> stroke;
  std::optional<Chart> sorted_chart;     ///< sorted copy of last_live, made on request
  const LiveChart* last_live = nullptr;  ///< chart of the open stroke, or of the last one
  SurfaceCurve last_curve;
  std::vector<Index> changed;  ///< vertices that the last call changed
  UndoJournal journal;
  std::vector<StrokeSolid> parts;
  SolidMerger merger;
  Progress progress;
  std::vector<MergeReport> merges;
  std::vector<std::string> warnings;  ///< of finished strokes
  std::uint64_t generation = 0;
  std::vector<TriangleMesh> bent_meshes;
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
  const std::span<const Index> seen = apply(stroke->draw({evaluator, paint.base(), cost, clock, progress}));
  clock.lap(Stage::move);
  return {StrokeEvent::Outcome::drawn, seen};
}

std::span<const Index> Session::Impl::apply(const VertexMoves& moves) {
  cost.moved = moves.vertices.size();
  const std::span<const Index> moved = shown.move(surface, moves.vertices, moves.positions);
  std::vector<Index> painted;
  if (!moves.tints.empty()) paint.set(moves.vertices, moves.tints, painted);
  std::ranges::sort(painted);
  return note_changed(moved, painted);
}

/// Sets `changed` to the union of two ascending lists.
std::span<const Index> Session::Impl::note_changed(std::span<const Index> moved,
                                                   std::span<const Index> painted) {
  changed.clear();
  std::ranges::set_union(moved, painted, std::back_inserter(changed));
  return changed;
}

/// Finishes the current piece, unless it is empty or kept.
std::span<const Index> Session::Impl::finish_piece(Closure closure) {
  if (stroke->piece_empty() || stroke->piece_kept()) return changed;
  StageClock clock(cost);
  apply(stroke->finish(closure, {evaluator, paint.base(), cost, clock, progress}));
  last_curve = stroke->curve();
  clock.lap(Stage::move);
  return changed;
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
    clock.lap(Stage::record);
    return changed;
  }
  const std::vector<Index> displaced = shown.take_displaced(surface);
  journal.record(displaced, surface.positions, paint.commit(), add_part());
  commit(displaced);
  stroke.reset();
  clock.lap(Stage::record);
  return changed;
}

/// What the stroke made, if anything.
MadePart Session::Impl::add_part() {
  if (stroke->bent()) {
    bent_meshes.push_back(std::move(*stroke->bent()));
    return MadePart::mesh;
  }
  std::optional<StrokeSolid>& solid = stroke->solid();
  if (!solid || solid->empty()) return MadePart::none;
  parts.push_back(std::move(*solid));
  return MadePart::solid;
}

/// Merges what the stroke made with the surface. The stroke is gone then.
void Session::Impl::merge_solid(const SolidMerge& merge) {
  if (!merger) throw Error("this application cannot merge solids with the surface");
  const MergedSolid merged = merger(merge);
  // The last time: from here on the surface is replaced.
  report(progress, "rebuilding the surface", 0);
  Stopwatch watch;
  PaintedSurface made = with_patch(surface, picker, paint.base(), merged.patch);
  MergeReport report = report_of(merged, surface, made.surface);
  report.solid_seconds = stroke->solid_seconds();
  stroke.reset();
  Paint before = paint.base();
  Surface replaced = std::move(surface);
  builders->free_strokes();
  replaced_builders.push_back(std::move(builders));
  replace_surface(std::move(made.surface), std::move(made.paint));
  builders = std::make_unique<ChartBuilders>(surface, picker);
  report.rebuild_seconds = watch.lap();
  merges.push_back(report);
  journal.record(std::move(replaced), std::move(before));
}

/// Brings back the surface that the last merge replaced.
void Session::Impl::restore_surface(Surface before, Paint painted) {
  replace_surface(std::move(before), std::move(painted));
  builders = std::move(replaced_builders.back());
  replaced_builders.pop_back();
  merges.pop_back();
}

/// All that depends on the surface is made anew, but for the chart builders.
void Session::Impl::replace_surface(Surface made, Paint painted) {
  last_live = nullptr;
  surface = std::move(made);
  picker = Picker(surface);
  shown = ShownSurface(surface);
  paint = ShownPaint(surface.vertex_count());
  paint.assign(std::move(painted));
  ++generation;
  changed.resize(surface.vertex_count());
  std::iota(changed.begin(), changed.end(), Index{0});
}

/// Copies the shown positions to the surface and updates everything that depends on it.
void Session::Impl::commit(std::span<const Index> displaced) {
  float farthest = 0;
  for (const Index vertex : displaced)
    farthest = std::max(farthest, (shown.positions()[vertex] - surface.positions[vertex]).squaredNorm());
  shown.commit(surface, displaced);
  picker.update(displaced);
  builders->moved(displaced, std::sqrt(static_cast<double>(farthest)));
}

void Session::Impl::drop() {
  if (!stroke) return;
  const std::vector<Index> displaced = shown.take_displaced(surface);
  std::vector<Vec3f> bases;
  bases.reserve(displaced.size());
  for (const Index vertex : displaced) bases.push_back(surface.positions[vertex]);
  note_changed(shown.move(surface, displaced, bases), paint.drop());
  shown.take_displaced(surface);
  stroke.reset();
}

void Session::Impl::set_paint(Paint given) {
  if (stroke) throw ContractError("a stroke is open");
  const Index count = surface.vertex_count();
  const auto one_each = [&](const auto& values) { return values.empty() || values.size() == count; };
  const auto within = [](const auto& value) { return value >= 0 && value <= 1; };
  const bool sound = one_each(given.colour) && one_each(given.mask) &&
                     std::ranges::all_of(given.mask, within) &&
                     std::ranges::all_of(given.colour, [&](const Vec4f& colour) {
                       return std::all_of(colour.begin(), colour.end(), within);
                     });
  if (!sound) throw ContractError("colours and masks must be from 0 to 1, one a vertex");
  paint.assign(std::move(given));
}

Session::Session(Surface surface, const BrushLibrary& brushes, SolidMerger merger) {
  if (surface.is_point_set()) throw ContractError("a point set cannot be sculpted");
  impl_ = std::make_unique<Impl>(std::move(surface), brushes, std::move(merger));
}
Session::~Session() = default;
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

const Surface& Session::surface() const { return impl_->surface; }
const Picker& Session::picker() const { return impl_->picker; }
std::span<const Vec3f> Session::positions() const { return impl_->shown.positions(); }
std::span<const Vec3f> Session::normals() const { return impl_->shown.normals(); }
std::uint64_t Session::generation() const { return impl_->generation; }
void Session::set_progress(Progress progress) { impl_->progress = std::move(progress); }

std::span<const StrokeSolid> Session::parts() const { return impl_->parts; }
std::span<const MergeReport> Session::merges() const { return impl_->merges; }
std::span<const std::string> Session::warnings() const { return impl_->warnings; }
std::span<const TriangleMesh> Session::bent_meshes() const { return impl_->bent_meshes; }
const Paint& Session::paint() const { return impl_->paint.shown(); }

void Session::set_paint(Paint paint) {
  impl_->guarded([&] { impl_->set_paint(std::move(paint)); });
}

void Session::begin_stroke(const StrokeSettings& settings) {
  impl_->guarded([&] {
    if (impl_->stroke) throw ContractError("a stroke is open already");
    const BrushEntry* entry = settings.along.given() ? nullptr : &impl_->brushes->find(settings.brush);
    const burin_brush_descriptor& descriptor = entry ? *entry->descriptor : no_brush_descriptor();
    impl_->stroke.emplace(impl_->surface, impl_->picker, *impl_->builders,
                          entry ? impl_->brush(*entry) : no_brush(), descriptor, settings);
    impl_->last_live = &impl_->stroke->live();
    impl_->paint.prepare(descriptor.outputs_written);
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
  impl_->changed.clear();
  impl_->drop();
}

std::span<const Index> Session::changed() const { return impl_->changed; }

const Chart& Session::chart() const {
  if (!impl_->sorted_chart) impl_->sorted_chart = impl_->last_live ? impl_->last_live->sorted() : Chart{};
  return *impl_->sorted_chart;
}
const SurfaceCurve& Session::curve() const {
  return impl_->stroke ? impl_->stroke->curve() : impl_->last_curve;
}

bool Session::undo() {
  return impl_->guarded([&] {
    if (impl_->stroke) throw ContractError("a stroke is open");
    std::optional<UndoStep> step = impl_->journal.take();
    if (!step) return false;
    StageClock clock(impl_->cost);
    if (step->surface) {
      impl_->restore_surface(std::move(*step->surface), std::move(step->surface_paint));
      clock.lap(Stage::record);
      return true;
    }
    impl_->note_changed(impl_->shown.move(impl_->surface, step->vertices, step->positions),
                        step->paint.vertices);
    impl_->cost.moved = step->vertices.size();
    clock.lap(Stage::move);
    impl_->commit(step->vertices);
    impl_->paint.restore(step->paint);
    if (step->made == MadePart::solid) impl_->parts.pop_back();
    if (step->made == MadePart::mesh) impl_->bent_meshes.pop_back();
    clock.lap(Stage::record);
    return true;
  });
}

const EventCost& Session::cost() const { return impl_->cost; }

std::uint64_t Session::result_hash() const {
  const auto ordered = [this](const auto& values) {
    std::vector<std::ranges::range_value_t<decltype(values)>> of_source(values.size());
    for (std::size_t v = 0; v < values.size(); ++v) of_source[impl_->surface.source_vertex[v]] = values[v];
    return hash_bytes(of_source.data(), of_source.size() * sizeof(of_source[0]));
  };
  std::vector<std::uint64_t> hashes{ordered(positions())};
  if (!paint().colour.empty() || !paint().mask.empty()) {
    hashes.push_back(ordered(paint().colour));
    hashes.push_back(ordered(paint().mask));
  }
  for (const StrokeSolid& part : parts())
    hashes.push_back(hash_bytes(part.blocks().data(), part.blocks().size_bytes()));
  for (const TriangleMesh& mesh : bent_meshes()) {
    hashes.push_back(hash_bytes(mesh.positions.data(), mesh.positions.size() * sizeof mesh.positions[0]));
    hashes.push_back(hash_bytes(mesh.triangles.data(), mesh.triangles.size() * sizeof mesh.triangles[0]));
  }
  return hashes.size() == 1 ? hashes.front() : hash_bytes(hashes.data(), hashes.size() * sizeof hashes[0]);
}

}  // namespace burin
