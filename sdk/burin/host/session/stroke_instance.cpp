// Traces and charts one symmetric image of a stroke, and finds the nodes whose results may have changed. An
// image that runs like the original takes over the nodes of the original's chart instead of computing its
// own.
#include <burin/along/along_parts.h>
#include <burin/host/session/stroke_instance.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace burin {
namespace {

/// A t that no node's t is below.
constexpr double everywhere = -std::numeric_limits<double>::infinity();

/// A t that no node reaches.
constexpr double nowhere = std::numeric_limits<double>::infinity();

DrivenStroke driven_stroke(const StrokeSettings& settings, const SymmetryInstance& image) {
  return {settings.fields, settings.radius, settings.seed, image.linear.transpose().cast<float>()};
}

}  // namespace

InstanceChartBuilders& ChartBuilders::operator[](std::size_t instance) {
  while (builders_.size() <= instance) builders_.push_back({StrokeChartBuilder(*surface_, &levels_), {}, {}});
  return builders_[instance];
}

void ChartBuilders::moved(std::span<const Index> vertices, double distance) {
  levels_.moved(vertices);
  for (InstanceChartBuilders& builders : builders_) builders.stroke.moved(vertices, distance);
}

LiveDabs& ChartBuilders::dabs(std::size_t instance) {
  std::unique_ptr<LiveDabs>& dabs = (*this)[instance].dabs;
  if (!dabs) dabs = std::make_unique<LiveDabs>(*surface_, *picker_);
  return *dabs;
}

LiveChart& ChartBuilders::image(std::size_t instance) {
  std::unique_ptr<LiveChart>& image = (*this)[instance].image;
  if (!image) image = std::make_unique<LiveChart>(surface_->vertex_count());
  image->clear();
  return *image;
}

StrokeInstance::StrokeInstance(const Surface& surface, const Picker& picker, ChartBuilders& builders,
                               const StrokeSettings& settings, const SymmetryInstance& image,
                               const BrushStroke& brush, const CurveFilter* filter,
                               const StrokeInstance* original)
    : surface_(&surface),
      image_(image),
      width_(settings.pressure_width, settings.dynamics, driven_stroke(settings, image)),
      dynamics_(brush.descriptor(), brush.params(), settings.dynamics, driven_stroke(settings, image)),
      reads_(read_inputs(settings, brush.descriptor().inputs_read)),
      end_influence_(brush.plan().end_influence),
      filter_(filter),
      original_(original),
      tracer_(begun(surface, picker, builders, settings, image), settings.radius, width_) {
  if (original) image_chart_.emplace(surface, picker, image, settings.radius, builders.image(image.index));
  nodes_.emplace(live(), reads_);
  if (filter && std::isfinite(filter->reach().ahead)) begin_moving();
}

void StrokeInstance::begin_moving() { moved_.emplace(tracer_, reads_.radius, width_, filter_->reach()); }

/// Lets the brush move what was drawn since the last call. `flags`: BURIN_STROKE_FINAL, at the end.
void StrokeInstance::move_curve(std::uint64_t flags) {
  const std::uint64_t of_image = flags | (image_.mirrored ? BURIN_STROKE_MIRRORED : 0);
  moved_->follow(drawn(), tracer_.final_points(), [&](const SurfaceCurve& curve, std::size_t first) {
    return filter_->offsets(curve, first, of_image);
  });
}

/// Starts the stroke's chart; returns the ground on which its curve must run.
CurveGround StrokeInstance::begun(const Surface& surface, const Picker& picker, ChartBuilders& builders,
                                  const StrokeSettings& settings, const SymmetryInstance& image) {
  const bool fine = settings.refining.kind != Refining::Kind::off;
  if (settings.dab_spacing > 0) {
    dabs_ = &builders.dabs(image.index);
    base_ = builders[image.index].stroke.base_for(settings.radius, settings.follow, fine);
    dabs_->begin(settings.radius, settings.dab_spacing * settings.radius, base_);
    return {surface, picker, base_};
  }
  builder_ = &builders[image.index].stroke;
  ChartOptions options{.radius = settings.radius,
                       .cap = settings.cap,
                       .join = settings.join,
                       .follow = settings.follow,
                       .fine = fine};
  if (settings.along.given()) {
    // Wider, on the same base surface, whose relief is as fine as radius * (1 - follow).
    options.radius *= AlongParts::chart_radii;
    options.follow = 1 - (1 - settings.follow) / AlongParts::chart_radii;
  }
  builder_->begin(options);
  base_ = builder_->base();
  return {surface, picker, base_};
}

ReadInputs StrokeInstance::read_inputs(const StrokeSettings& settings, std::uint64_t inputs) const {
  std::uint64_t varying = pen_inputs_present(settings.fields);
  if (width_.varies()) varying |= BURIN_INPUT_RADIUS;
  // The half width is always needed, since sheets fade over a share of it.
  return {settings.radius, inputs, varying & (inputs | BURIN_INPUT_RADIUS), &dynamics_};
}

void StrokeInstance::trace(const CurveGround::Point& at, double time, const Pen& pen) {
  const PenPath::Change change = tracer_.add(at, time, pen);
  const bool pen_matters = width_.varies() || reads_.varying != 0 || dynamics_.any();
  traced_ |= change == PenPath::Change::path || (change == PenPath::Change::pen && pen_matters);
}

StrokeChanges StrokeInstance::draw(std::uint64_t flags, EventCost& cost) {
  const std::size_t unchanged = drawn_points_;
  const double length_before = drawn_length_;
  if (moved_) move_curve(flags);
  drawn_points_ = moved_ ? moved_->final_points() : tracer_.final_points();
  drawn_length_ = curve().length();
  traced_ = false;
  chart(unchanged, cost);
  const double same_up_to = unchanged > 0 ? curve().points[unchanged - 1].t : everywhere;
  // A dab does not depend on the stroke's length.
  double end_zone = dabs_ ? nowhere : std::min(length_before, drawn_length_) - end_influence_;
  const double same_curve_up_to = std::min(same_up_to, length_before);
  if (reads_foot()) end_zone = std::min(end_zone, other_feet_from(same_curve_up_to));
  return nodes_->follow(curve(), end_zone, same_up_to, ends(same_curve_up_to));
}

/// The t from which on feet may differ if the curve is unchanged up to another t. All nodes before the start
/// share the start's foot.
double StrokeInstance::other_feet_from(double same_curve_up_to) const {
  const double from = same_curve_up_to - reads_.radius;
  return from > 0 ? from : everywhere;
}

/// The distances from the ends of a curve that is unchanged up to this t. Those near the begin differ as long
/// as what they look at grows, if it bends.
StrokeEnds StrokeInstance::ends(double same_curve_up_to) {
  if (!ends_) return {};
  const bool bends = ends_->begin_bends(), bent = std::exchange(begin_bent_, bends);
  const bool grows =
      bends && same_curve_up_to <= end_influence_ + EndDistances::reach(reads_.radius, end_influence_);
  return {&*ends_, bends != bent || grows ? end_influence_ : everywhere};
}

StrokeChanges StrokeInstance::finish(bool news, EventCost& cost) {
  const bool moves_at_last = filter_ && !moved_;
  if (moves_at_last) begin_moving();
  if (closed_curve_ || moves_at_last) {
    if (moved_) move_curve(BURIN_STROKE_FINAL);
    chart(0, cost);
    return nodes_->follow(curve(), everywhere, everywhere, ends(everywhere));
  }
  if (news || moved_) return draw(BURIN_STROKE_FINAL, cost);
  return nodes_->in_zone(dabs_ ? nowhere : curve().length() - end_influence_);
}

NodeSource StrokeInstance::source(const Paint& paint) const {
  return {.surface = *surface_,
          .nodes = *nodes_,
          .radius = static_cast<float>(reads_.radius),
          .paint = &paint,
          .foot = foot_ ? &*foot_ : nullptr,
          .before = nullptr,
          .symmetry = image_.index,
          .mirrored = image_.mirrored,
          .dab_t = dab_t(),
          .base = base_};
}

std::span<const float> StrokeInstance::dab_t() const {
  if (!dabs_) return {};
  return image_chart_ && image_chart_->reflects() ? original_->dab_t() : dabs_->along();
}

/// Whether the image's curve matches the original's. It is traced on its own part of the surface, which may
/// differ.
bool StrokeInstance::runs_like_original() const {
  const SurfaceCurve &here = curve(), &there = original_->curve();
  return here.closed == there.closed && std::abs(here.length() - there.length()) <= 1e-4 * reads_.radius;
}

void StrokeInstance::chart(std::size_t unchanged, EventCost& cost) {
  if (!image_chart_) {
    chart_own(unchanged, cost);
  } else if (image_chart_->has_images_of(original_->live()) && runs_like_original()) {
    image_chart_->reflect(original_->live());
  } else {
    chart_own(image_chart_->own_is_behind() ? 0 : unchanged, cost);
    image_chart_->copy(own_live());
  }
  look_along();
}

/// Prepares the inputs that depend on more of the curve than a point of it.
void StrokeInstance::look_along() {
  const bool reflects = image_chart_ && image_chart_->reflects();
  if (reads_foot())
    foot_.emplace(reflects ? image_chart_->image_of(original_->curve()) : curve(), reads_.radius);
  if (!reads_end_distance()) return;
  if (dabs_)
    ends_.emplace(end_influence_);
  else if (reflects)
    ends_.emplace(original_->curve(), reads_.radius, end_influence_,
                  [this](const Vec3f& position) { return image_chart_->moved(position); });
  else
    ends_.emplace(curve(), reads_.radius, end_influence_);
}

void StrokeInstance::chart_own(std::size_t unchanged, EventCost& cost) {
  if (dabs_) {
    dabs_->draw(curve(), unchanged);
    cost.settled += dabs_->settled();
  } else {
    builder_->draw(curve(), unchanged);
    cost.settled += builder_->settled();
    cost.pushes += builder_->pushes();
  }
}

}  // namespace burin
