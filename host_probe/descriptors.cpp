// Describes the probe's two brushes: one reads and writes everything in several passes, the other makes a
// solid and moves the curve.
#include "descriptors.h"

namespace burin_probe {
namespace {

constexpr burin_param_info param(burin_param_type type, const char* id, const char* name) {
  burin_param_info info{};
  info.struct_size = sizeof info;
  info.type = type;
  info.id = id;
  info.name = name;
  info.unit = BURIN_UNIT_NONE;
  return info;
}

constexpr burin_param_info number(burin_param_type type, const char* id, const char* name, float least,
                                  float greatest, float value) {
  burin_param_info info = param(type, id, name);
  info.hard_min = info.soft_min = least;
  info.hard_max = info.soft_max = greatest;
  info.default_number = value;
  return info;
}

constexpr burin_param_info dynamic(burin_param_info info) {
  info.dynamic = 1;
  return info;
}

constexpr burin_param_info in_radii(burin_param_info info) {
  info.unit = BURIN_UNIT_RADIUS;
  return info;
}

constexpr const char* profiles[] = {"round", "flat", nullptr};
constexpr float knots[] = {0, 0, 1, 1};

constexpr burin_param_info choice() {
  burin_param_info info = param(BURIN_PARAM_CHOICE, "profile", "Profile");
  info.choices = profiles;
  return info;
}

constexpr burin_param_info colour() {
  burin_param_info info = param(BURIN_PARAM_COLOUR, "tint", "Tint");
  for (float& channel : info.default_colour) channel = 0.5f;
  return info;
}

constexpr burin_param_info optional_file() {
  burin_param_info info = param(BURIN_PARAM_FILE, "file", "File");
  info.default_file = "";
  return info;
}

constexpr burin_param_info slope() {
  burin_param_info info = param(BURIN_PARAM_CURVE, "curve", "Curve");
  info.default_knots = knots;
  info.default_knot_count = 2;
  return info;
}

constexpr burin_param_info infos[param_count] = {
    in_radii(dynamic(number(BURIN_PARAM_FLOAT, "height", "Height", 0, 1, 0.25f))),
    number(BURIN_PARAM_INT, "count", "Count", 0, 9, 3),
    param(BURIN_PARAM_BOOL, "on", "On"),
    choice(),
    colour(),
    optional_file(),
    slope(),
    param(BURIN_PARAM_TEXT, "text", "Text"),
    number(BURIN_PARAM_INT, "passes", "Passes", 1, 4, 2)};
constexpr const burin_param_info* params[param_count] = {
    &infos[0], &infos[1], &infos[2], &infos[3], &infos[4], &infos[5], &infos[6], &infos[7], &infos[8]};
constexpr const char* features[] = {"probe", nullptr};

constexpr burin_brush_descriptor described(const char* id, const char* name, const char* help,
                                           std::uint64_t inputs, std::uint64_t outputs) {
  burin_brush_descriptor descriptor{};
  descriptor.struct_size = sizeof descriptor;
  descriptor.param_count = param_count;
  descriptor.id = id;
  descriptor.name = name;
  descriptor.vendor = "Burin";
  descriptor.version = "1.0.0";
  descriptor.help = help;
  descriptor.features = features;
  descriptor.params = params;
  descriptor.inputs_read = inputs;
  descriptor.outputs_written = outputs;
  // displacement() rises by 1.54 times the height at most.
  descriptor.rim_slope = 1.6f;
  return descriptor;
}

constexpr std::uint64_t all_inputs = (BURIN_INPUT_END_DISTANCE << 1) - 1;

}  // namespace

constexpr burin_brush_descriptor everything = described(
    "org.burin.probe", "Probe", "Tells what the host does wrong, in the file that BURIN_PROBE_REPORT names.",
    all_inputs, BURIN_OUTPUT_DISPLACEMENT | BURIN_OUTPUT_MASK | BURIN_OUTPUT_COLOUR);
constexpr burin_brush_descriptor solid = described(
    "org.burin.probe.solid", "Probe of solids", "Tells what the host does wrong with solids and curves.",
    BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS | BURIN_INPUT_NODE_ID, BURIN_OUTPUT_DISPLACEMENT);
const burin_brush_descriptor* const descriptors[brush_count] = {&everything, &solid};

}  // namespace burin_probe
