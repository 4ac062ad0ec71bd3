// Checks a brush's descriptor member by member before any other code reads it.
#include <burin/host/plugin/descriptor_check.h>
#include <fmt/format.h>

#include <set>
#include <string_view>

namespace burin {
namespace {

/// Whether this is a reverse DNS name: at least two words of letters, digits, - and _, separated by dots.
bool is_brush_id(const char* id) {
  if (!id) return false;
  bool dotted = false, in_word = false;
  for (const char* at = id; *at != '\0'; ++at) {
    const bool letter = (*at >= 'a' && *at <= 'z') || (*at >= 'A' && *at <= 'Z');
    const bool word = letter || (*at >= '0' && *at <= '9') || *at == '-' || *at == '_';
    if (!word && (*at != '.' || !in_word)) return false;
    dotted |= *at == '.';
    in_word = word;
  }
  return dotted && in_word;
}

std::string params_problem(const burin_brush_descriptor& descriptor) {
  if (descriptor.param_count > 0 && !descriptor.params) return "counts parameters but lists none";
  std::set<std::string_view> ids;
  for (std::uint32_t i = 0; i < descriptor.param_count; ++i) {
    const burin_param_info* info = descriptor.params[i];
    if (!info) return fmt::format("parameter {} is null", i);
    if (std::string problem = param_problem(*info); !problem.empty()) return problem;
    if (!ids.insert(info->id).second) return fmt::format("two parameters '{}'", info->id);
  }
  return {};
}

std::string texts_problem(const burin_brush_descriptor& descriptor) {
  if (!is_text(descriptor.name)) return "no proper name";
  if (!is_text(descriptor.vendor)) return "no proper vendor";
  if (!is_text(descriptor.version)) return "no proper version";
  if (descriptor.help && !is_text(descriptor.help)) return "its help is no text";
  if (!descriptor.features) return "no list of features";
  for (const char* const* feature = descriptor.features; *feature; ++feature)
    if (!is_text(*feature)) return "a feature that is no text";
  return {};
}

std::string overlap_problem(const burin_brush_descriptor& descriptor) {
  if (!BURIN_HAS(&descriptor, burin_brush_descriptor, overlap)) return {};
  const burin_overlap overlap = descriptor.overlap;
  if (overlap >= BURIN_OVERLAP_UNKNOWN && overlap <= BURIN_OVERLAP_AVERAGE) return {};
  return fmt::format("overlap {} is none that there is", overlap);
}

std::string rim_problem(const burin_brush_descriptor& descriptor) {
  if (!BURIN_HAS(&descriptor, burin_brush_descriptor, rim_slope) || descriptor.rim_slope >= 0) return {};
  return fmt::format("its rim slope is {}", descriptor.rim_slope);
}

}  // namespace

std::string descriptor_problem(const burin_brush_descriptor& descriptor) {
  if (!BURIN_HAS(&descriptor, burin_brush_descriptor, outputs_written))
    return "a brush descriptor's struct_size is too small";
  if (!is_brush_id(descriptor.id)) return "a brush's id is no reverse DNS name such as org.example.brush";
  std::string problem = texts_problem(descriptor);
  if (problem.empty()) problem = params_problem(descriptor);
  if (problem.empty()) problem = overlap_problem(descriptor);
  if (problem.empty()) problem = rim_problem(descriptor);
  return problem.empty() ? problem : fmt::format("brush {}: {}", descriptor.id, problem);
}

}  // namespace burin
