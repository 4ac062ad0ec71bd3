// Computes what an event of the pen moves: for each symmetric image it extends curve and chart and evaluates
// the stale nodes, then it blends the sheets of all images vertex by vertex. Solids and meshes along the
// stroke are made when a piece ends.
#include <burin/base/error.h>
#include <burin/base/sort_unique.h>
#include <burin/base/stopwatch.h>
#include <burin/deform/blend/blend.h>
#include <burin/host/session/open_stroke.h>
#include <burin/surface/append_mesh.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace burin {
namespace {

void check(const AlongSettings& along) {
  const auto unit = [](const Vec3d& axis) { return std::abs(axis.norm() - 1) < 1e-9; };
  if (!unit(along.forward) || !unit(along.up) || std::abs(along.forward.dot(along.up)) > 1e-9)
    throw ContractError("the axes of meshes along a stroke must be unit vectors at right angles");
  if (!(along.spacing >= 0 && std::isfinite(along.spacing)))
    throw ContractError(
        fmt::format("the spacing of meshes along a stroke must be 0 or above, not {}", along.spacing));
  if (!std::isfinite(along.twist) || !std::isfinite(along.height))
    throw ContractError("twist and height of meshes along a stroke must be finite");
}

/// With meshes along the stroke there is no brush whose parameters there could be, and their chart goes on
/// beyond its ends.
StrokeSettings checked(StrokeSettings settings) {
  // Brushes compute in floats, so the values must be finite and positive as floats.
  const auto radius = static_cast<float>(settings.radius), strength = static_cast<float>(settings.strength);
  if (!(std::isfinite(radius) && radius > 0))
    throw ContractError(fmt::format("a stroke's radius must be above 0, not {}", settings.radius));
  if (!(settings.pressure_width >= 0 && settings.pressure_width <= 1))
    throw ContractError(
        fmt::format("a stroke's pressure width must be from 0 to 1, not {}", settings.pressure_width));
  if (!(settings.follow >= 0 && settings.follow <= 1))
    throw ContractError(
        fmt::format("how much a stroke follows must be from 0 to 1, not {}", settings.follow));
  if (!std::isfinite(strength)) throw ContractError("a stroke's strength is not finite");
  if (!(settings.dab_spacing == 0 || settings.dab_spacing >= least_dab_spacing))
    throw ContractError(fmt::format("the spacing of dabs must be 0, or at least {} radii, not {}",
                                    least_dab_spacing, settings.dab_spacing));
  if (!(settings.voxel >= 0 && std::isfinite(settings.voxel)))
    throw ContractError(fmt::format("a solid's voxel must be 0 or above, not {}", settings.voxel));
  if (!(settings.blend >= 0 && std::isfinite(settings.blend)))
    throw ContractError(fmt::format("a solid's blend must be 0 or above, not {}", settings.blend));
  if (settings.along.given()) {
    check(settings.along);
    settings.params.clear();
    settings.cap = Cap::round;
  }
  return settings;
}

/// Throws ContractError if the pen has a value in a field that it does not report, since the value would be
/// ignored.
void check_pen(const Pen& pen, const PenFields& fields) {
  const Pen neutral;
  const auto check = [](bool reported, bool is_neutral, const char* field, float value) {
    if (!reported && !is_neutral)
      throw ContractError(fmt::format(
          "the pen's {} is {}, but StrokeSettings::fields says that it reports none", field, value));
  };
  check(fields.pressure, pen.pressure == neutral.pressure, "pressure", pen.pressure);
  check(fields.tilt, pen.tilt_x == neutral.tilt_x, "tilt", pen.tilt_x);
  check(fields.tilt, pen.tilt_y == neutral.tilt_y, "tilt", pen.tilt_y);
  check(fields.twist, pen.twist == neutral.twist, "twist", pen.twist);
}

/// The vertices that changed in any instance, each once.
std::vector<Index> all_vertices(const std::vector<StrokeChanges>& changes) {
  std::vector<Index> vertices = changes.front().vertices;
  if (changes.size() == 1) return vertices;
  for (std::size_t i = 1; i < changes.size(); ++i)
    vertices.insert(vertices.end(), changes[i].vertices.begin(), changes[i].vertices.end());
  sort_unique(vertices);
  return vertices;
}

}  // namespace

OpenStroke::OpenStroke(const Surface& surface, const Picker& picker, ChartBuilders& builders,
                       const burin_brush& brush, const burin_brush_descriptor& descriptor,
                       const StrokeSettings& settings)
    : surface_(&surface),
      picker_(&picker),
      builders_(&builders),
      settings_(checked(settings)),
      params_(descriptor, settings_.params),
      narrowest_(StrokeWidth(settings.pressure_width, settings.dynamics,
                             {.fields = settings.fields, .radius = settings.radius, .seed = settings.seed})
                     .narrowest()),
      brush_stroke_(brush, descriptor, context(0, {}), params_.abi()),
      curve_filter_(CurveFilter::of(brush_stroke_, context(0, {}))),
      images_(symmetry_instances(settings_.symmetry)),
      last_time_(-std::numeric_limits<double>::infinity()) {
  if (settings_.along.given()) {
    if (settings_.dab_spacing > 0) throw Error("meshes cannot be bent along a row of dabs");
    along_.emplace(settings_.along);
  } else if (makes_solid()) {
    if (settings_.dab_spacing > 0) throw Error(fmt::format("{}: makes no solids of dabs", descriptor.id));
    solid_stroke_.emplace(brush_stroke_);
  }
  begin_instances();
}

bool OpenStroke::makes_solid() const {
  if (settings_.solid) return settings_.solid != SolidOperation::none;
  return brush().outputs_written == 0 && brush_stroke_.extension(BURIN_EXT_VOLUME);
}

void OpenStroke::begin_instances() {
  for (const SymmetryInstance& image : images_)
    instances_.emplace_back(*surface_, *picker_, *builders_, settings_, image, brush_stroke_,
                            curve_filter_ ? &*curve_filter_ : nullptr,
                            instances_.empty() ? nullptr : &instances_.front());
  if (makes_part()) return;
  if (settings_.accumulate == Accumulate::from_current) accumulate();
  if (passes_read_neighbours()) set_up_passes();
}

void OpenStroke::begin_piece() {
  piece_kept_ = false;
  passes_.reset();
  accumulation_.reset();
  instances_.clear();
  begin_instances();
}

/// Sets up passes that read neighbours, which need the result of the previous pass at these.
void OpenStroke::set_up_passes() {
  std::vector<const LiveChart*> charts;
  for (const StrokeInstance& instance : instances_) charts.push_back(&instance.live());
  passes_.emplace(*surface_, brush_stroke_, std::move(charts), blend_options());
}

void OpenStroke::accumulate() {
  if (brush_stroke_.plan().passes > 1)
    throw Error(fmt::format("{}: works in several passes, which start from the surface before the stroke",
                            brush().id));
  accumulation_.emplace(*surface_, brush_stroke_, settings_.dab_spacing > 0 ? 0 : settings_.radius);
}

bool OpenStroke::passes_read_neighbours() const {
  return brush().inputs_read & BURIN_INPUT_LAPLACIAN && brush_stroke_.plan().passes > 1;
}

BlendOptions OpenStroke::blend_options() const {
  const bool adds_up = settings_.accumulate == Accumulate::from_current;
  const Overlap chosen =
      over_passes(settings_.overlap.value_or(overlap_of(brush())), brush_stroke_.plan().passes);
  BlendOptions options{.overlap = adds_up ? Overlap::add : chosen, .radius = settings_.radius};
  if (settings_.clamp_to_radius) options.limit = settings_.radius;
  return options;
}

void OpenStroke::trace(const CurveGround::Point& at, double time, const Pen& pen) {
  if (!std::isfinite(time) || time < last_time_)
    throw ContractError(fmt::format("time goes from {} to {}", last_time_, time));
  check_pen(pen, settings_.fields);
  last_time_ = time;
  instances_.front().trace(at, time, pen);
  for (std::size_t i = 1; i < instances_.size(); ++i) {
    StrokeInstance& instance = instances_[i];
    const Vec3f position = instance.image()(at.at.position.cast<double>()).cast<float>();
    const auto image = instance.ground().closest(position, static_cast<float>(settings_.radius));
    if (image && instance.connects(*image)) instance.trace(*image, time, pen);
  }
}

VertexMoves OpenStroke::draw(const StrokeTools& tools) {
  // Parts are made at the end.
  if (makes_part() || std::ranges::none_of(instances_, &StrokeInstance::has_changes)) return {};
  std::vector<StrokeChanges> changes;
  for (StrokeInstance& instance : instances_)
    changes.push_back(instance.empty() ? StrokeChanges{} : instance.draw(tools.cost));
  tools.clock.lap(Stage::chart);
  return evaluate_and_blend(changes, 0, tools);
}

VertexMoves OpenStroke::finish(Closure closure, const StrokeTools& tools) {
  for (StrokeInstance& instance : instances_)
    if (!instance.empty()) instance.close(closure);
  tools.clock.lap(Stage::curve);
  const bool news = std::ranges::any_of(instances_, &StrokeInstance::has_changes);
  std::vector<StrokeChanges> changes;
  for (StrokeInstance& instance : instances_)
    changes.push_back(instance.empty() ? StrokeChanges{} : instance.finish(news, tools.cost));
  tools.clock.lap(Stage::chart);
  if (!makes_part()) return evaluate_and_blend(changes, BURIN_STROKE_FINAL, tools);
  Stopwatch watch;
  along_ ? bend_meshes(tools.paint) : make_solid(tools);
  solid_seconds_ += watch.lap();
  tools.clock.lap(Stage::evaluate);
  return {};
}

/// Adds those of the piece's images to the solid of the stroke.
void OpenStroke::make_solid(const StrokeTools& tools) {
  for (const StrokeInstance& instance : instances_) {
    if (instance.empty()) continue;
    const std::uint64_t mirrored = instance.image().mirrored ? BURIN_STROKE_MIRRORED : 0;
    const NodeSource source = instance.source(tools.paint);
    const burin_stroke_context of_image = context(BURIN_STROKE_FINAL | mirrored, instance.curve());
    // Voxels of one size go together.
    const double voxel = solid_ ? solid_->voxel() : settings_.voxel;
    solid_operation_ = settings_.solid ? *settings_.solid : solid_stroke_->operation(of_image);
    StrokeSolid made = solid_stroke_->make(source, of_image, voxel, merges(solid_operation_), tools.progress);
    check_slope(made);
    if (solid_)
      solid_->add(made);
    else
      solid_ = std::move(made);
  }
}

void OpenStroke::check_slope(const StrokeSolid& made) {
  constexpr double least = 0.5, most = 2;
  const double slope = median_slope(made);
  if (!warnings_.empty() || (slope >= least && slope <= most)) return;
  warnings_.push_back(
      fmt::format("{}: what it gives as the distance to its solid changes by {:.2g} over a length of 1; "
                  "a distance changes by 1, and voxels and fillets rely on it",
                  brush().id, slope));
}

/// Adds those along the piece's images to the part of the stroke.
void OpenStroke::bend_meshes(const Paint& paint) {
  for (const StrokeInstance& instance : instances_) {
    if (instance.empty()) continue;
    const NodeSource source = instance.source(paint);
    const Chart chart = instance.live().sorted();
    const SurfaceCurve& curve = instance.curve();
    const SolidGround ground{*surface_, chart, [&](Index vertex) { return source.base_position(vertex); }};
    TriangleMesh made =
        along_->bend({.ground = ground,
                      .radius = settings_.radius,
                      .width = [&](double t) { return static_cast<double>(pen_at(curve, t).width); },
                      .mirrored = instance.image().mirrored});
    if (made.triangles.empty()) continue;
    if (!bent_) bent_.emplace();
    append(made, *bent_);
  }
}

/// Edge of the voxels in which bent meshes are merged: about as long as their edges.
double OpenStroke::mesh_voxel() const {
  constexpr double coarsest = 8, finest = 24;  // voxels over the radius
  if (settings_.voxel > 0) return settings_.voxel;
  double sum = 0;
  for (const Triangle& t : bent_->triangles)
    for (std::size_t i = 0; i < 3; ++i)
      sum += static_cast<double>((bent_->positions[t[(i + 1) % 3]] - bent_->positions[t[i]]).norm());
  const double mean = sum / (3 * static_cast<double>(bent_->triangles.size()));
  return std::clamp(mean, settings_.radius / finest, settings_.radius / coarsest);
}

std::optional<SolidMerge> OpenStroke::merge() const {
  if (bent_ && settings_.solid && merges(*settings_.solid))
    return SolidMerge{*surface_, *picker_, MeshSolid{*bent_, mesh_voxel()}, *settings_.solid,
                      settings_.blend};
  if (solid_ && !solid_->empty() && merges(solid_operation_))
    return SolidMerge{*surface_, *picker_, *solid_, solid_operation_, settings_.blend};
  return {};
}

burin_stroke_context OpenStroke::context(std::uint64_t flags, const SurfaceCurve& curve) const {
  burin_stroke_context context{};
  context.struct_size = sizeof(burin_stroke_context);
  context.flags = flags | (curve.closed ? BURIN_STROKE_CLOSED : 0);
  context.pen_present = pen_inputs_present(settings_.fields);
  context.seed = settings_.seed;
  context.length = curve.length();
  context.radius_min = settings_.radius * narrowest_;
  context.radius_max = settings_.radius;
  context.object_scale = surface_->scale;
  return context;
}

/// Evaluates stale nodes and computes the new positions and tints of their vertices.
VertexMoves OpenStroke::evaluate_and_blend(const std::vector<StrokeChanges>& changes, std::uint64_t flags,
                                           const StrokeTools& tools) {
  std::vector<Index> vertices = all_vertices(changes);
  evaluate(changes, flags, tools, vertices);
  tools.clock.lap(Stage::evaluate);
  VertexMoves moves = blend(std::move(vertices), tools.paint);
  tools.clock.lap(Stage::blend);
  return moves;
}

void OpenStroke::evaluate(const std::vector<StrokeChanges>& changes, std::uint64_t flags,
                          const StrokeTools& tools, std::vector<Index>& vertices) {
  const auto strength = static_cast<float>(settings_.strength);
  std::vector<EvaluatedInstance> evaluated;
  for (StrokeInstance& instance : instances_) {
    instance.outputs().resize(instance.live().nodes().size(), paints(brush()));
    const std::uint64_t mirrored = instance.image().mirrored ? BURIN_STROKE_MIRRORED : 0;
    evaluated.push_back({instance.source(tools.paint), context(flags | mirrored, instance.curve()), strength,
                         instance.outputs()});
  }
  if (passes_) {
    vertices = passes_->update(tools.evaluator, evaluated, std::move(vertices));
    tools.cost.evaluated += vertices.size();
    return;
  }
  if (accumulation_) {
    const std::vector<Index> changed = vertices;
    for (std::size_t i = 0; i < evaluated.size(); ++i)
      accumulation_->update(tools.evaluator, evaluated[i], instances_[i].live(), changed, vertices);
    sort_unique(vertices);
    tools.cost.evaluated += vertices.size();
    return;
  }
  for (std::size_t i = 0; i < evaluated.size(); ++i) {
    const std::vector<Index>& stale = changes[i].stale;
    const NodeOutputs& outputs =
        tools.evaluator.evaluate(brush_stroke_, evaluated[i].context, evaluated[i].source, stale, strength);
    for (std::size_t k = 0; k < stale.size(); ++k) evaluated[i].outputs.take(stale[k], outputs, k);
    tools.cost.evaluated += stale.size();
  }
}

std::vector<InstanceSheets> OpenStroke::piece_sheets() const {
  std::vector<InstanceSheets> sheets;
  for (const StrokeInstance& instance : instances_) sheets.push_back(instance.sheets());
  return sheets;
}

VertexMoves OpenStroke::blend(std::vector<Index> vertices, const Paint& paint) const {
  const std::vector<InstanceSheets> piece = piece_sheets();
  const StrokeSheets stroke{piece, &earlier_};
  VertexMoves moves;
  moves.vertices = std::move(vertices);
  moves.positions.resize(moves.vertices.size());
  blend_sheets(*surface_, stroke, moves.vertices, blend_options(), brush().id, moves.positions);
  if (!paints(brush())) return moves;
  moves.tints.resize(moves.vertices.size());
  blend_tints(paint, stroke, moves.vertices, blend_options(), moves.tints);
  return moves;
}

void OpenStroke::keep_piece() {
  // The part has all of it.
  if (!makes_part()) earlier_.add(piece_sheets(), settings_.radius);
  piece_kept_ = true;
}

}  // namespace burin
