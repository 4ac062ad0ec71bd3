// A host of the plugin ABI that breaks one rule, and no other: wrong_host PROBE RULE. With the rule "none" it
// breaks none. It draws one stroke of two passes over a few nodes, makes a solid, and saves a state.
#include <burin/abi/ext/curve_filter.h>
#include <burin/abi/ext/log.h>
#include <burin/abi/ext/state.h>
#include <burin/abi/ext/volume.h>
#include <burin/abi/plugin.h>
#include <dlfcn.h>
#include <sched.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <limits>
#include <string_view>
#include <thread>
#include <vector>

namespace {

std::string_view broken_rule;

bool breaks(std::string_view rule) { return rule == broken_rule; }

template <class Value>
Value wrong_if(std::string_view rule, Value wrong, Value right) {
  return breaks(rule) ? wrong : right;
}

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

void write_line(const burin_host*, burin_log_severity, const char*) {}

const void* find_service(const burin_host*, const char* id) {
  static const burin_log log{sizeof(burin_log), 0, breaks("host.services") ? nullptr : write_line};
  const std::string_view name = id;
  return name == BURIN_EXT_LOG || (breaks("host.unknown") && !name.starts_with("burin.")) ? &log : nullptr;
}

burin_host host{sizeof(burin_host), BURIN_ABI_MAJOR, BURIN_ABI_MINOR, 0, nullptr, "wrong host", "1",
                find_service};

/// Runs a call where the rule asks for it: on another thread if it is broken.
template <class Run>
void on_thread(std::string_view rule, const Run& run) {
  if (!breaks(rule)) return run();
  std::thread(run).join();
}

/// A number, the same for all nodes.
burin_floats all(const float& value) { return {&value, 0, 0}; }

/// The values of the probe's parameters.
struct Params {
  Params() {
    for (int i : {0, 1, 2, 3, 8}) values[i].number = all(numbers[i]);
    for (burin_floats& channel : values[4].colour) channel = all(numbers[4]);
    values[5].text = "";
    values[6].knots = knots;
    values[6].knot_count = 2;
    values[7].text = "text";
  }
  Params(const Params&) = delete;
  Params& operator=(const Params&) = delete;

  float numbers[9] = {0.25f, 3, 0, 0, 0.5f, 0, 0, 0, 2};
  float knots[4] = {0, 0, 1, 1};
  burin_param_value values[9] = {};
  burin_params abi{sizeof(burin_params), 9, values};
};

/// Nodes on a straight stroke of length 1, all alike, with their outputs.
struct Nodes {
  explicit Nodes(std::uint32_t count) : outputs_of(8 * std::size_t{count}) {
    abi.struct_size = sizeof abi;
    abi.count = count;
    abi.params = &params.abi;
    for (burin_floats* array :
         {&abi.t, &abi.d, &abi.radius, &abi.stretch, &abi.footprint_t, &abi.footprint_d})
      *array = all(tenth);
    for (burin_vectors* vectors : {&abi.normal, &abi.foot_normal, &abi.fine_normal})
      *vectors = {all(zero), all(zero), all(one)};
    for (burin_vectors* vectors : {&abi.position, &abi.laplacian, &abi.foot, &abi.fine_position})
      *vectors = {all(zero), all(zero), all(zero)};
    abi.displacement = {all(zero), all(zero), all(before)};
    abi.e1 = {all(one), all(zero), all(zero)};
    abi.mean_curvature = abi.fine_mean_curvature = abi.end_distance = all(zero);
    abi.mask = all(one);
    abi.colour = {all(zero), all(zero), all(zero), all(zero)};
    abi.sheet = abi.node_id = abi.symmetry = {&first, 0, 0};
    abi.visit_count = {&single, 0, 0};
    abi.pressure = all(one);
    abi.tilt_x = abi.tilt_y = abi.twist = abi.speed = abi.time = all(zero);
    abi.d = all(zero);
  }
  Nodes(const Nodes&) = delete;
  Nodes& operator=(const Nodes&) = delete;

  void keep_declared(std::uint64_t inputs) {
    burin_batch few{};
    few.struct_size = abi.struct_size;
    few.count = abi.count;
    few.params = abi.params;
    if (inputs & BURIN_INPUT_T) few.t = abi.t;
    if (inputs & BURIN_INPUT_D) few.d = abi.d;
    if (inputs & BURIN_INPUT_RADIUS) few.radius = abi.radius;
    if (inputs & BURIN_INPUT_NODE_ID) few.node_id = abi.node_id;
    if (breaks("batch.undeclared")) few.mask = abi.mask;
    abi = few;
  }

  void break_rule() {
    if (breaks("batch.declared")) abi.mean_curvature = {};
    if (breaks("batch.finite")) abi.mean_curvature = all(not_finite);
    if (breaks("batch.radius")) abi.radius = all(one);
    if (breaks("batch.band")) abi.d = all(one);
    if (breaks("batch.unit")) abi.normal.z = all(tenth);
    if (breaks("batch.tangent")) abi.e1 = abi.normal;
    if (breaks("batch.ranges")) abi.twist = all(eight), pen_present |= BURIN_INPUT_TWIST;
    if (breaks("batch.neutral")) abi.speed = all(one);
    if (breaks("batch.sheets")) abi.sheet = {&single, 0, 0};
    if (breaks("param.constant")) params.numbers[1] = 4;
    if (breaks("param.range")) params.numbers[0] = 7;
  }

  burin_outputs outputs() {
    burin_outputs out{};
    out.struct_size = sizeof out;
    out.count = wrong_if("batch.size", abi.count + 1, abi.count);
    burin_floats_out* all_outputs[] = {&out.along,     &out.across,    &out.up,        &out.mask,
                                       &out.colour[0], &out.colour[1], &out.colour[2], &out.colour[3]};
    for (std::size_t i = 0; i < 8; ++i) *all_outputs[i] = {&outputs_of[i * abi.count], 1, 0};
    std::fill(outputs_of.begin(), outputs_of.end(), wrong_if("outputs.filled", 1.0f, 0.0f));
    for (std::uint32_t i = 0; i < abi.count; ++i) out.mask.data[i] = 1;
    if (breaks("outputs.declared")) out.along.stride = 0;
    return out;
  }

  static constexpr float zero = 0, one = 1, tenth = 0.1f, eight = 8, not_finite = nan;
  static constexpr std::uint32_t first = 0, single = 1;
  float before = 0;  ///< displacement of the previous pass
  std::uint64_t pen_present = 0;
  Params params;
  burin_batch abi{};
  std::vector<float> outputs_of;
};

burin_stroke_context context(double length, std::uint64_t flags) {
  return {.struct_size = sizeof(burin_stroke_context),
          .pass = 0,
          .flags = flags,
          .pen_present = breaks("batch.ranges") ? BURIN_INPUT_TWIST : 0,
          .seed = 1,
          .length = length,
          .radius_min = 0.1,
          .radius_max = 0.1,
          .object_scale = 2,
          .dab_t = 0};
}

char error_line[256];
burin_text error{sizeof(burin_text), sizeof error_line, error_line};

void* begin(const burin_brush& brush, const Params& params) {
  burin_stroke_context empty = context(wrong_if("begin.context", 1.0, 0.0), 0);
  burin_stroke_plan plan{sizeof(burin_stroke_plan), wrong_if("begin.plan", 0U, 1U), 0};
  burin_params given = params.abi;
  burin_param_value values[9];
  std::copy_n(params.values, 9, values);
  given.values = values;
  const float falling[] = {1, 0, 0, 0};
  if (breaks("begin.numbers")) values[0].number.stride = 1;
  if (breaks("param.curve")) values[6].knots = falling;
  if (breaks("param.text")) values[7].text = nullptr;
  burin_text text = error;
  if (breaks("text.buffer")) text.data = nullptr;
  void* stroke = nullptr;
  if (breaks("param.count")) {
    // The probe refuses such a stroke.
    burin_params few = given;
    few.count = 3;
    brush.begin(&brush, &empty, &few, &plan, &stroke, &text);
  }
  brush.begin(&brush, &empty, &given, &plan, &stroke, &text);
  return stroke;
}

void break_context(burin_stroke_context& now) {
  if (breaks("context.pass")) now.pass = 9;
  if (breaks("context.constant")) now.seed = 2;
  if (breaks("context.flags")) now.flags = BURIN_STROKE_CLOSED;
  if (breaks("context.length")) now.length = std::numeric_limits<double>::infinity();
  if (breaks("context.dab")) now.dab_t = 1;
}

/// The passes of a finished stroke.
void evaluate(const burin_brush& brush, void* stroke, Nodes& nodes, std::uint32_t passes) {
  for (std::uint32_t pass = 0; pass < passes; ++pass) {
    burin_stroke_context now = context(1, BURIN_STROKE_FINAL);
    now.pass = pass;
    break_context(now);
    burin_outputs outputs = nodes.outputs();
    brush.evaluate(&brush, stroke, &now, &nodes.abi, &outputs, &error);
    nodes.before = wrong_if("batch.passes", 0.0f, outputs.up.data[0]);
  }
}

/// A number that nobody can read before open(): until then a reader is kept waiting. One at a time.
class Gate {
 public:
  explicit Gate(float number) {
    page_ = mmap(nullptr, size(), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    *static_cast<float*>(page_) = number;
    mprotect(page_, size(), PROT_NONE);
    struct sigaction action {};
    action.sa_flags = SA_SIGINFO;
    action.sa_sigaction = [](int, siginfo_t* fault, void*) {
      if (fault->si_addr != page_) {
        signal(SIGSEGV, SIG_DFL);
        return;
      }
      reader_waits_ = true;
      while (!open_) sched_yield();
      mprotect(page_, size(), PROT_READ);
    };
    sigaction(SIGSEGV, &action, nullptr);
  }
  const float& number() const { return *static_cast<const float*>(page_); }
  static void wait_for_reader() {
    while (!reader_waits_) std::this_thread::yield();
  }
  static void open() { open_ = true; }

 private:
  static std::size_t size() { return static_cast<std::size_t>(sysconf(_SC_PAGESIZE)); }
  static inline void* page_ = nullptr;
  static inline std::atomic<bool> reader_waits_{false}, open_{false};
};

/// Ends a stroke while an evaluation of it waits for a number.
void end_while_evaluating(const burin_brush& brush, void* stroke, Nodes& nodes) {
  const Gate gate(0.1f);
  nodes.abi.t = all(gate.number());
  nodes.before = 0;
  std::thread running([&] { evaluate(brush, stroke, nodes, 1); });
  Gate::wait_for_reader();
  brush.end(&brush, stroke);
  Gate::open();
  running.join();
}

void draw_everything(const burin_brush& brush) {
  Nodes nodes(5);
  void* stroke = begin(brush, nodes.params);
  nodes.break_rule();
  evaluate(brush, stroke, nodes, 2);
  if (breaks("destroy.strokes")) return;
  if (breaks("stroke.running")) return end_while_evaluating(brush, stroke, nodes);
  on_thread("stroke.thread", [&] { brush.end(&brush, stroke); });
  if (breaks("stroke.open")) evaluate(brush, stroke, nodes, 1);
}

void move_curve(const burin_brush& brush, void* stroke, const Params& params) {
  const auto& filter =
      *static_cast<const burin_curve_filter*>(brush.get_extension(&brush, BURIN_EXT_CURVE_FILTER));
  burin_curve_reach reach{sizeof(burin_curve_reach), 0, 0, wrong_if("curve.reach", 1.0, 0.0)};
  filter.reach(&brush, stroke, &reach);
  const float t[] = {wrong_if("curve.points", 1.0f, 0.0f), 0.5f}, zeros[2] = {}, ones[] = {1, 1};
  float along[2] = {}, across[] = {0, wrong_if("curve.offsets", 1.0f, 0.0f)};
  const burin_vectors up{{zeros, 1, 0}, {zeros, 1, 0}, {ones, 1, 0}};
  const burin_curve_points points{sizeof(burin_curve_points), 2, {t, 1, 0}, up, up, up};
  const burin_stroke_context now = context(1, 0);
  filter.filter(&brush, stroke, &now, &params.abi, &points, {along, 1, 0}, {across, 1, 0}, &error);
}

void draw_solid(const burin_brush& brush, const burin_brush_descriptor& descriptor) {
  Nodes nodes(5);
  void* stroke = begin(brush, nodes.params);
  move_curve(brush, stroke, nodes.params);
  const auto& volume = *static_cast<const burin_volume*>(brush.get_extension(&brush, BURIN_EXT_VOLUME));
  burin_stroke_context now = context(1, wrong_if("solid.plan", BURIN_STROKE_MIRRORED, BURIN_STROKE_FINAL));
  burin_solid_plan plan{sizeof(burin_solid_plan), 0, 0, 0, 0};
  volume.plan(&brush, stroke, &now, &nodes.params.abi, &plan, &error);
  nodes.keep_declared(descriptor.inputs_read);
  const float h = wrong_if("solid.points", nan, 0.0f);
  float distances[5];
  volume.distance(&brush, stroke, &now, &nodes.abi, {&h, 0, 0}, {distances, 1, 0}, &error);
  brush.end(&brush, stroke);
}

void save_state(const burin_brush& brush) {
  const auto& state = *static_cast<const burin_state*>(brush.get_extension(&brush, BURIN_EXT_STATE));
  const Params params;
  void* stroke = breaks("state.when") ? begin(brush, params) : nullptr;
  std::uint64_t size = 0;
  std::uint32_t data = 0;
  state.save(&brush, wrong_if<void*>("state.data", nullptr, &data), sizeof data, &size, &error);
  if (stroke) brush.end(&brush, stroke);
  state.load(&brush, state.version, &data, sizeof data, &error);
}

void destroy(const burin_brush& brush) {
  if (breaks("brush.destroyed")) return;
  if (breaks("host.lives")) host.name = "another";
  brush.destroy(&brush);
  if (breaks("brush.alive")) brush.destroy(&brush);
}

void use(const burin_brush_factory& factory) {
  const burin_brush_factory copy = factory;
  if (breaks("host.complete")) host.version = nullptr;
  const burin_brush* brushes[2] = {};
  on_thread("main.thread", [&] {
    for (int i = 0; i < 2; ++i)
      brushes[i] =
          factory.create(breaks("create.factory") ? &copy : &factory, &host, factory.brushes[i]->id, &error);
  });
  if (breaks("extension.id")) brushes[0]->get_extension(brushes[0], nullptr);
  draw_everything(*brushes[0]);
  draw_solid(*brushes[1], *factory.brushes[1]);
  save_state(*brushes[1]);
  for (const burin_brush* brush : brushes) destroy(*brush);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  broken_rule = argv[2];
  void* module = dlopen(argv[1], RTLD_NOW | RTLD_LOCAL);
  if (!module) return std::fprintf(stderr, "%s\n", dlerror()), 2;
  const auto& entry = *static_cast<const burin_plugin_entry*>(dlsym(module, BURIN_PLUGIN_SYMBOL));
  if (breaks("factory.when")) entry.get_factory(BURIN_BRUSH_FACTORY);
  entry.init(wrong_if<const char*>("init.path", "", argv[1]), &error);
  use(*static_cast<const burin_brush_factory*>(entry.get_factory(BURIN_BRUSH_FACTORY)));
  if (!breaks("init.paired")) entry.deinit();
  dlclose(module);
  return 0;
}
