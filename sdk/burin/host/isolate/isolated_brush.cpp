// Makes requests of the functions of a brush and of its abilities.
#if defined(__linux__)
#include <burin/abi/ext/log.h>
#include <burin/host/isolate/isolated_brush.h>
#include <burin/host/isolate/stroke_message.h>
#include <burin/plugin/detail/complete.h>
#include <burin/plugin/detail/error.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>

namespace burin::isolate {
namespace {

using plugin::complete;
using plugin::guarded;

/// The most passes of a stroke: each batch has a deadline of its own, so their number needs a bound.
constexpr std::uint32_t most_passes = 10000;

void BURIN_CALL destroy(const burin_brush* brush) { delete &IsolatedBrush::of(brush); }

const void* BURIN_CALL get_extension(const burin_brush* brush, const char* id) {
  return id ? IsolatedBrush::of(brush).extension(id) : nullptr;
}

burin_status BURIN_CALL begin(const burin_brush* brush, const burin_stroke_context* context,
                              const burin_params* params, burin_stroke_plan* plan, void** stroke,
                              burin_text* error) {
  return guarded(error, [&] {
    burin_stroke_plan made = complete(*plan);
    *stroke = IsolatedBrush::of(brush).begin(complete(*context), *params, made);
    std::memcpy(plan, &made, std::min<std::size_t>(plan->struct_size, sizeof made));
  });
}

burin_status BURIN_CALL evaluate(const burin_brush* brush, void* stroke, const burin_stroke_context* context,
                                 const burin_batch* batch, const burin_outputs* outputs, burin_text* error) {
  return guarded(error, [&] {
    BatchCall call{.context = complete(*context), .batch = complete(*batch), .outputs = complete(*outputs)};
    IsolatedBrush::of(brush).run(stroke, call);
  });
}

void BURIN_CALL end(const burin_brush* brush, void* stroke) { IsolatedBrush::of(brush).end(stroke); }

void BURIN_CALL curve_reach(const burin_brush* brush, void* stroke, burin_curve_reach* reach) {
  const std::uint32_t size = reach->struct_size;
  burin_curve_reach told = complete(*reach);
  // There is no status: a reach that is no number makes the host end the stroke.
  if (guarded(nullptr, [&] { told = IsolatedBrush::of(brush).reach(stroke, told); }) != BURIN_OK)
    told.behind = told.ahead = -1;
  told.struct_size = size;
  std::memcpy(reach, &told, std::min<std::size_t>(size, sizeof told));
}

burin_status BURIN_CALL curve_filter(const burin_brush* brush, void* stroke,
                                     const burin_stroke_context* context, const burin_params*,
                                     const burin_curve_points* points, burin_floats_out along,
                                     burin_floats_out across, burin_text* error) {
  return guarded(
      error, [&] { IsolatedBrush::of(brush).filter(stroke, complete(*context), *points, along, across); });
}

burin_status BURIN_CALL solid_plan(const burin_brush* brush, void* stroke,
                                   const burin_stroke_context* context, const burin_params*,
                                   burin_solid_plan* plan, burin_text* error) {
  return guarded(error, [&] {
    burin_solid_plan made = IsolatedBrush::of(brush).plan(stroke, complete(*context), complete(*plan));
    made.struct_size = plan->struct_size;
    std::memcpy(plan, &made, std::min<std::size_t>(plan->struct_size, sizeof made));
  });
}

burin_status BURIN_CALL solid_distance(const burin_brush* brush, void* stroke,
                                       const burin_stroke_context* context, const burin_batch* batch,
                                       burin_floats h, burin_floats_out distance, burin_text* error) {
  return guarded(error, [&] {
    BatchCall call{.what = Batch::distance,
                   .context = complete(*context),
                   .batch = complete(*batch),
                   .height = h,
                   .distance = distance};
    IsolatedBrush::of(brush).run(stroke, call);
  });
}

burin_status BURIN_CALL save_state(const burin_brush* brush, void* data, std::uint64_t capacity,
                                   std::uint64_t* size, burin_text* error) {
  return guarded(error, [&] {
    std::uint32_t version = 0;
    const Bytes state = IsolatedBrush::of(brush).save(version);
    *size = state.size();
    if (!data || capacity < state.size())
      throw plugin::Error("the state needs more room", BURIN_INVALID_ARGUMENT);
    if (!state.empty()) std::memcpy(data, state.data(), state.size());
  });
}

burin_status BURIN_CALL load_state(const burin_brush* brush, std::uint32_t version, const void* data,
                                   std::uint64_t size, burin_text* error) {
  return guarded(error, [&] {
    IsolatedBrush::of(brush).load(version,
                                  {static_cast<const std::byte*>(data), static_cast<std::size_t>(size)});
  });
}

constexpr burin_curve_filter filter_table{sizeof(burin_curve_filter), 0, curve_reach, curve_filter};
constexpr burin_volume volume_table{sizeof(burin_volume), 0, solid_plan, solid_distance};

/// Copies floats that came as bytes to an array of `count`.
void take_floats(std::span<const std::byte> bytes, burin_floats_out to, std::uint32_t count) {
  if (bytes.size() != count * sizeof(float))
    throw Error("its process answered with another number of offsets");
  for (std::size_t i = 0; i < count; ++i)
    std::memcpy(to.data + i * to.stride, bytes.data() + i * sizeof(float), sizeof(float));
}

}  // namespace

IsolatedBrush::IsolatedBrush(BrushOrigin origin)
    : brush_{sizeof(burin_brush), 0,           this, destroy, isolate::get_extension, isolate::begin,
             isolate::evaluate,   isolate::end},
      state_table_{sizeof(burin_state), 0, save_state, load_state},
      origin_(std::move(origin)) {
  const std::lock_guard lock(mutex_);
  start();
}

/// Asks, and throws Error with the status of the brush if that is no success.
Answer IsolatedBrush::ask(BrushProcess& process, Request what, const MessageWriter& content) {
  const Isolation& isolation = origin_.isolation;
  const double seconds = what == Request::create ? isolation.load_seconds : isolation.call_seconds;
  Answer answer = process.request(what, content, seconds);
  if (answer.status() == BURIN_OK) return answer;
  doubtful_ = true;
  throw plugin::Error(answer.text(), answer.status());
}

void IsolatedBrush::start() {
  process_.reset();
  doubtful_ = false;
  auto process = std::make_shared<BrushProcess>(origin_.isolation, origin_.log);
  MessageWriter content;
  content.text(origin_.module.string()).text(origin_.brush);
  const Answer answer = ask(*process, Request::create, content);
  MessageReader reader = answer.content();
  offers_ = reader.value<std::uint32_t>();
  state_table_.version = reader.value<std::uint32_t>();
  const std::span<const std::byte> threads = reader.block(), descriptors = reader.block();
  if (!std::ranges::equal(descriptors, origin_.descriptors))
    throw Error("its module is another one than when it was loaded; load it anew");
  std::vector<pid_t> numbers(std::min(threads.size() / sizeof(pid_t), process->lane_count()));
  std::memcpy(numbers.data(), threads.data(), numbers.size() * sizeof(pid_t));
  process->set_lane_threads(std::move(numbers));
  restore_state(*process);
  if (process->has_failed()) return start();
  process_ = std::move(process);
}

/// Gives a new process the state. One that it does not take is dropped, so that it fails once only.
void IsolatedBrush::restore_state(BrushProcess& process) {
  if (!state_) return;
  try {
    ask(process, Request::load_state, MessageWriter().value(state_version_).block(*state_));
  } catch (const std::exception& error) {
    state_.reset();
    if (origin_.log)
      origin_.log(BURIN_LOG_WARNING, fmt::format("{}: its state is lost: {}", origin_.brush, error.what()));
  }
}

/// The process, a new one if the last has ended or its brush has failed, which may have taken all memory it
/// may.
BrushProcess& IsolatedBrush::running() {
  if (!process_ || !process_->is_running() || doubtful_) start();
  return *process_;
}

const void* IsolatedBrush::extension(std::string_view id) const {
  if (id == BURIN_EXT_CURVE_FILTER && (offers_ & offers_curve_filter)) return &filter_table;
  if (id == BURIN_EXT_VOLUME && (offers_ & offers_volume)) return &volume_table;
  if (id == BURIN_EXT_STATE && (offers_ & offers_state)) return &state_table_;
  return nullptr;
}

void* IsolatedBrush::begin(const burin_stroke_context& context, const burin_params& params,
                           burin_stroke_plan& plan) {
  const std::lock_guard lock(mutex_);
  BrushProcess& process = running();
  std::unique_ptr<Stroke> stroke(new Stroke{process_, ++strokes_});
  MessageWriter content;
  std::error_code no_folder;
  content.text(std::filesystem::current_path(no_folder).string()).value(stroke->number).value(context);
  write_params(content, params);
  const std::uint32_t size = plan.struct_size;
  const Answer answer = ask(process, Request::begin, content.value(plan));
  plan = answer.content().value<burin_stroke_plan>();
  plan.struct_size = size;
  if (plan.passes <= most_passes) return stroke.release();
  ask(process, Request::end, MessageWriter().value(stroke->number));
  throw Error(fmt::format("asked for {} passes; in a process of its own a brush has at most {}", plan.passes,
                          most_passes));
}

void IsolatedBrush::run(void* stroke, BatchCall& call) {
  const Stroke& at = *static_cast<const Stroke*>(stroke);
  call.stroke = at.number;
  const std::size_t count = call.batch.count, most = elements_that_fit(call);
  try {
    for (std::size_t first = 0; first < count; first += most)
      at.process->run(call, first, std::min(most, count - first));
  } catch (const plugin::Error&) {
    doubtful_ = true;
    throw;
  }
}

void IsolatedBrush::end(void* stroke) {
  const std::lock_guard lock(mutex_);
  const std::unique_ptr<Stroke> at(static_cast<Stroke*>(stroke));
  if (at->process->has_failed()) return;
  burin_text no_text{};
  guarded(&no_text, [&] {
    const Answer answer = ask(*at->process, Request::end, MessageWriter().value(at->number));
    MessageReader reader = answer.content();
    keep_state(reader);
  });
  if (!at->process->has_failed()) return;
  // Nobody waits for an error of this call.
  if (origin_.log)
    origin_.log(BURIN_LOG_WARNING, fmt::format("{}: {}", origin_.brush, at->process->failure()));
}

/// Keeps the state that came with an answer, if one did.
void IsolatedBrush::keep_state(MessageReader& from) {
  if (from.left() == 0) return;
  state_version_ = from.value<std::uint32_t>();
  const std::span<const std::byte> state = from.block();
  state_.emplace(state.begin(), state.end());
}

burin_curve_reach IsolatedBrush::reach(void* stroke, const burin_curve_reach& reach) {
  const std::lock_guard lock(mutex_);
  const Stroke& at = *static_cast<const Stroke*>(stroke);
  const Answer answer = ask(*at.process, Request::curve_reach, MessageWriter().value(at.number).value(reach));
  return answer.content().value<burin_curve_reach>();
}

void IsolatedBrush::filter(void* stroke, const burin_stroke_context& context,
                           const burin_curve_points& points, burin_floats_out along,
                           burin_floats_out across) {
  const std::lock_guard lock(mutex_);
  const Stroke& at = *static_cast<const Stroke*>(stroke);
  MessageWriter content;
  content.value(at.number).value(context);
  write_points(content, points);
  const Answer answer = ask(*at.process, Request::curve_filter, content);
  MessageReader reader = answer.content();
  take_floats(reader.block(), along, points.count);
  take_floats(reader.block(), across, points.count);
}

burin_solid_plan IsolatedBrush::plan(void* stroke, const burin_stroke_context& context,
                                     const burin_solid_plan& plan) {
  const std::lock_guard lock(mutex_);
  const Stroke& at = *static_cast<const Stroke*>(stroke);
  const Answer answer =
      ask(*at.process, Request::solid_plan, MessageWriter().value(at.number).value(context).value(plan));
  return answer.content().value<burin_solid_plan>();
}

Bytes IsolatedBrush::save(std::uint32_t& version) {
  const std::lock_guard lock(mutex_);
  const Answer answer = ask(running(), Request::save_state, {});
  MessageReader reader = answer.content();
  keep_state(reader);
  version = state_version_;
  return state_.value_or(Bytes());
}

void IsolatedBrush::load(std::uint32_t version, std::span<const std::byte> state) {
  const std::lock_guard lock(mutex_);
  ask(running(), Request::load_state, MessageWriter().value(version).block(state));
  state_version_ = version;
  state_.emplace(state.begin(), state.end());
}

}  // namespace burin::isolate
#endif
