// Every public function of Session forwards to Impl. Functions that can fail run inside Impl::guarded(),
// which resets the cost and the list of changed vertices and drops the open stroke if anything throws.
#include <burin/base/error.h>
#include <burin/base/stopwatch.h>
#include <burin/host/session.h>
#include <burin/host/session/created_brushes.h>
#include <burin/host/session/merged_surface.h>
#include <burin/host/session/no_brush.h>
#include <burin/host/session/open_stroke.h>
#include <burin/host/session/sculpted_surface.h>
#include <burin/host/session/stroke_products.h>
#include <burin/host/session/stroke_refining.h>
#include <burin/surface/patch_uv.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace burin {

struct Session::Impl {
  Impl(Surface given, const BrushLibrary& library, SolidMerger solid_merger)
      : surface(std::move(given)), brushes(library), merger(std::move(solid_merger)) {}

  OpenStroke& open_stroke();
  StrokeEvent add(const GivenSample& given, Show show);
  StrokeEvent draw(const std::optional<CurveGround::Point>& at, const GivenSample& given, Show show,
                   StageClock& clock);
  std::optional<CurveGround::Point> locate(const GivenSample& given);
  OpenStroke& stroke_for_sample();
  std::span<const Index> end_piece(Closure closure);
  std::span<const Index> finish_piece(Closure closure);
  std::span<const Index> finish(Closure closure);
  std::span<const Index> apply(const VertexMoves& moves);
  void merge_solid(const SolidMerge& merge);
  void keep_products();
  void drop();
  void open(const BrushEntry* entry, const StrokeSettings& settings);
  void begin_refining(const BrushEntry* entry, const StrokeSettings& settings, std::span<const Vec3d> path,
                      const LaterStrokes& later);
  bool refine(const PathRefinement& refinement);
  bool refine_at(const SurfacePoint& at);
  bool refine_to_error(Closure closure);
  std::size_t refined_triangles() const;
  void draw_again();
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
  CreatedBrushes brushes;
  Evaluator evaluator;
  std::optional<OpenStroke> stroke;
  StrokeRefining refining;
  std::optional<Chart> sorted_chart;     ///< sorted copy of last_live, made on request
  const LiveChart* last_live = nullptr;  ///< chart of the open stroke, or of the last one
  SurfaceCurve last_curve;
  StrokeProducts products;
  SolidMerger merger;
  Progress progress;
  std::vector<std::string> warnings;  ///< of finished strokes
  EventCost cost;
};

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

/// The point of the ground at which a sample points.
std::optional<CurveGround::Point> Session::Impl::locate(const GivenSample& given) {
  const OpenStroke& to = stroke_for_sample();
  if (const Ray* ray = std::get_if<Ray>(&given.at)) return to.ground().pick(*ray);
  const Vec3f position = std::get<Vec3d>(given.at).cast<float>();
  return to.ground().closest(position, static_cast<float>(to.radius()));
}

StrokeEvent Session::Impl::add(const GivenSample& given, Show show) {
  stroke_for_sample();
  StageClock clock(cost);
  std::optional<CurveGround::Point> at = locate(given);
  const bool is_other = at && refining.is_on() && refine_at(at->on_surface);
  if (is_other) at = locate(given);
  StrokeEvent event = draw(at, given, is_other ? Show::now : show, clock);
  if (refining.is_on() && event.outcome == StrokeEvent::Outcome::drawn)
    refining.given().add(given, at->on_surface.position.cast<double>());
  if (is_other) event.changed = surface.note_all_changed();
  return event;
}

StrokeEvent Session::Impl::draw(const std::optional<CurveGround::Point>& at, const GivenSample& given,
                                Show show, StageClock& clock) {
  clock.lap(Stage::pick);
  if (!at) return {StrokeEvent::Outcome::off_surface, {}};
  if (!stroke->connects(*at)) return {StrokeEvent::Outcome::disconnected, {}};
  stroke->trace(*at, given.time, given.pen);
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
    drop();
    return surface.changed();
  }
  finish_piece(closure);
  const bool is_other = refine_to_error(closure);
  warnings.insert(warnings.end(), stroke->warnings().begin(), stroke->warnings().end());
  StageClock clock(cost);
  if (std::optional<SolidMerge> merge = stroke->merge()) {
    merge->progress = progress;
    merge_solid(*merge);
    keep_products();
    clock.lap(Stage::record);
    return surface.changed();
  }
  const std::uint64_t before = surface.generation();
  PathCoarsening coarser = refining.coarser(surface);
  const MadePart made = products.add(*stroke);
  if (!coarser.patch.removed.empty()) {
    stroke.reset();
    last_live = nullptr;
  }
  refining.keep(made, std::move(coarser), surface);
  keep_products();
  stroke.reset();
  clock.lap(Stage::record);
  const bool is_coarser = surface.generation() != before;
  return is_other || is_coarser ? surface.note_all_changed() : surface.changed();
}

void Session::Impl::keep_products() {
  if (const auto report = refining.take_report()) products.refinements.there.push_back(*report);
  products.end_redoing();
}

/// Merges what the stroke made with the surface. The stroke is gone then.
void Session::Impl::merge_solid(const SolidMerge& merge) {
  if (!merger) throw Error("this application cannot merge solids with the surface");
  surface.require_all_shown();
  MergedSolid merged = merger(merge);
  // The last time: from here on the surface is replaced.
  report(progress, "rebuilding the surface", 0);
  Stopwatch watch;
  merged.patch.triangle_uv = carried_uv(surface.base(), surface.picker(), merged.patch);
  PaintedPatch made = with_patch(surface.base(), surface.picker(), surface.paint().base(), merged.patch);
  MergeReport report = report_of(merged, surface.base(), made.painted.surface);
  report.solid_seconds = stroke->solid_seconds();
  stroke.reset();
  last_live = nullptr;
  surface.replace(std::move(made));
  report.rebuild_seconds = watch.lap();
  products.merges.there.push_back(report);
}

void Session::Impl::drop() {
  if (!stroke && !surface.is_refined()) return;
  stroke.reset();
  refining.take_report();
  // Its charts are gone with the refined surface.
  if (surface.is_refined()) last_live = nullptr;
  surface.drop();
}

void Session::Impl::open(const BrushEntry* entry, const StrokeSettings& settings) {
  const burin_brush_descriptor& descriptor = entry ? *entry->descriptor : no_brush_descriptor();
  stroke.emplace(surface.base(), surface.picker(), surface.builders(),
                 entry ? brushes.brush(*entry, warnings) : no_brush(), descriptor, settings);
  last_live = &stroke->live();
  surface.prepare_paint(descriptor.outputs_written);
}

/// Puts what was made for the open stroke into the surface, if anything must be done. The stroke is closed
/// then, to be opened anew. Returns whether it is. Warns of what would take too many triangles.
bool Session::Impl::refine(const PathRefinement& refinement) {
  if (std::string why = refining.declined(refinement); !why.empty()) {
    warnings.push_back(std::move(why));
    return false;
  }
  if (!refining.changes(refinement)) return false;
  if (refinement.made) surface.require_all_shown();
  stroke.reset();
  last_live = nullptr;
  refining.apply(refinement, surface);
  return true;
}

/// Refines the surface where the pen comes to, if it must, and draws the stroke so far again.
bool Session::Impl::refine_at(const SurfacePoint& at) {
  if (!refine(refining.at(surface, at.position.cast<double>()))) return false;
  draw_again();
  return true;
}

std::size_t Session::Impl::refined_triangles() const {
  std::size_t added = 0, removed = 0;
  for (const RefineReport& report : products.refinements.there) {
    added += report.triangles_added;
    removed += report.triangles_removed;
  }
  return added - std::min(added, removed);
}

/// Refines the surface where a stroke will go, and where later ones will.
void Session::Impl::begin_refining(const BrushEntry* entry, const StrokeSettings& settings,
                                   std::span<const Vec3d> path, const LaterStrokes& later) {
  refining.begin(entry, settings, refined_triangles(), later);
  // Before anything is refined, as the settings may be bad.
  open(entry, refining.given().settings_now());
  if (refine(refining.along(surface, path))) open(entry, refining.given().settings_now());
}

/// Refines the surface until it represents the finished stroke as exactly as its settings say, and finishes
/// it on that; returns whether it did.
bool Session::Impl::refine_to_error(Closure closure) {
  if (!refining.is_on()) return false;
  // Edges at steps get a third as long each time: from radius / 16 to radius / 128 it takes two.
  constexpr int most_passes = 3;
  for (int pass = 0; pass < most_passes; ++pass) {
    if (!refine(refining.to_error(surface))) return pass > 0;
    draw_again();
    finish_piece(closure);
  }
  return true;
}

/// Opens the stroke anew, with the samples that it had.
void Session::Impl::draw_again() {
  const GivenSamples& given = refining.given();
  open(given.entry, given.settings_now());
  for (const GivenSamples::Piece& piece : given.pieces) {
    for (const GivenSample& sample : piece.samples)
      if (const auto at = locate(sample); at && stroke->connects(*at))
        stroke->trace(*at, sample.time, sample.pen);
    if (piece.ended) end_piece(*piece.ended);
  }
}

/// Undoes the last step, or makes the last undone one again; returns false if there is none.
bool Session::Impl::take(Turn turn) {
  std::optional<UndoStep> step = surface.take_step(turn);
  if (!step) return false;
  StageClock clock(cost);
  if (step->surface) {
    last_live = nullptr;
  } else {
    surface.show(*step);
    cost.moved = step->vertices.size();
    clock.lap(Stage::move);
  }
  products.take(*step, turn);
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
Index Session::kept_vertices() const { return impl_->surface.kept_vertices(); }
void Session::set_progress(Progress progress) { impl_->progress = std::move(progress); }

std::span<const StrokeSolid> Session::parts() const { return impl_->products.parts.there; }
std::span<const MergeReport> Session::merges() const { return impl_->products.merges.there; }
std::span<const RefineReport> Session::refinements() const { return impl_->products.refinements.there; }
std::span<const std::string> Session::warnings() const { return impl_->warnings; }
std::span<const TriangleMesh> Session::bent_meshes() const { return impl_->products.bent_meshes.there; }
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

void Session::hide(const std::vector<bool>& hidden) {
  impl_->guarded([&] {
    if (impl_->stroke) throw ContractError("a stroke is open");
    impl_->surface.hide(hidden);
    impl_->last_live = nullptr;
  });
}

void Session::begin_stroke(const StrokeSettings& settings, std::span<const Vec3d> path,
                           const LaterStrokes& later) {
  impl_->guarded([&] {
    if (impl_->stroke) throw ContractError("a stroke is open already");
    const BrushEntry* entry =
        settings.along.given() ? nullptr : &impl_->brushes.library().find(settings.brush);
    impl_->refining.end();
    if (settings.refining.kind == Refining::Kind::off)
      impl_->open(entry, settings);
    else
      impl_->begin_refining(entry, settings, path, later);
  });
}

StrokeEvent Session::add_sample(const Ray& ray, double time, const Pen& pen, Show show) {
  return impl_->guarded([&] { return impl_->add({ray, time, pen}, show); });
}

StrokeEvent Session::add_sample(const Vec3d& position, double time, const Pen& pen, Show show) {
  return impl_->guarded([&] { return impl_->add({position, time, pen}, show); });
}

/// Finishes the current piece and keeps it.
std::span<const Index> Session::Impl::end_piece(Closure closure) {
  OpenStroke& of = open_stroke();
  const std::span<const Index> seen = finish_piece(closure);
  if (!of.piece_empty() && !of.piece_kept()) of.keep_piece();
  return seen;
}

std::span<const Index> Session::end_piece(Closure closure) {
  return impl_->guarded([&] {
    const std::span<const Index> seen = impl_->end_piece(closure);
    if (impl_->refining.is_on()) impl_->refining.given().end_piece(closure);
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

std::size_t Session::undo_dropped() const { return impl_->surface.undo_dropped(); }

std::optional<StrokeStep> Session::take_step() {
  return impl_->guarded([&] {
    if (impl_->stroke) throw ContractError("a stroke is open");
    return impl_->surface.release_step();
  });
}

void Session::apply(StrokeStep& step) {
  impl_->guarded([&] {
    if (impl_->stroke) throw ContractError("a stroke is open");
    StageClock clock(impl_->cost);
    impl_->surface.apply(step);
    impl_->cost.moved = step.vertices.size();
    clock.lap(Stage::move);
  });
}

const EventCost& Session::cost() const { return impl_->cost; }

}  // namespace burin
