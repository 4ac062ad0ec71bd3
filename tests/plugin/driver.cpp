#include "driver.h"

#include <dlfcn.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace burin::test {

namespace {

constexpr std::uint64_t first_handle = 7;

TestHost& self(const burin_host* host) { return *static_cast<TestHost*>(host->self); }

void write_line(const burin_host* host, burin_log_severity severity, const char* line) {
  self(host).lines.emplace_back(severity, line);
}

void write(burin_text* text, const std::string& line) {
  const std::size_t size = line.copy(text->data, text->capacity - 1);
  text->data[size] = '\0';
}

burin_status open_with(const burin_host* host, const char* path, const burin_stamp_options* options,
                       burin_stamp* stamp, burin_stamp_info* info, burin_text* error) {
  const auto found = self(host).pictures.find(path);
  if (found == self(host).pictures.end()) {
    write(error, std::string(path) + ": no such file");
    return BURIN_NOT_FOUND;
  }
  const auto known = [](burin_stamp_wrap wrap) { return wrap ? wrap : BURIN_WRAP_PERIODIC; };
  const TestPicture& picture = found->second;
  self(host).stamps.push_back({picture, known(options->wrap_u), known(options->wrap_v)});
  ++self(host).open_stamps;
  stamp->handle = first_handle + self(host).stamps.size() - 1;
  *info = {sizeof(burin_stamp_info),
           picture.width,
           picture.height,
           picture.channels,
           0,
           3,
           self(host).stamps.back().wrap_u,
           self(host).stamps.back().wrap_v};
  return BURIN_OK;
}

burin_status open_stamp(const burin_host* host, const char* path, burin_stamp* stamp, burin_stamp_info* info,
                        burin_text* error) {
  const burin_stamp_options options{sizeof options, 0, 0, 0, nullptr, nullptr, 0, 0};
  return open_with(host, path, &options, stamp, info, error);
}

void close_stamp(const burin_host* host, burin_stamp stamp) {
  if (stamp.handle < first_handle || self(host).open_stamps == 0)
    throw std::logic_error("a stamp is closed that was not open");
  --self(host).open_stamps;
}

/// Into 0..1 by the wrap; false where there is nothing.
bool wrapped(double& u, burin_stamp_wrap wrap) {
  if (wrap == BURIN_WRAP_BLACK) return u >= 0 && u <= 1;
  if (wrap == BURIN_WRAP_CLAMP) u = std::clamp(u, 0.0, 1.0);
  if (wrap == BURIN_WRAP_MIRROR) u = std::abs(u - 2 * std::round(u / 2));
  if (wrap == BURIN_WRAP_PERIODIC) u -= std::floor(u);
  return true;
}

burin_status sample_stamp(const burin_host* host, burin_stamp stamp, std::uint32_t channel,
                          std::uint32_t count, burin_floats u, burin_floats v, burin_floats_out values) {
  const TestHost::Stamp& opened = self(host).stamps.at(stamp.handle - first_handle);
  if (channel >= opened.picture.channels) return BURIN_INVALID_ARGUMENT;
  for (std::uint32_t i = 0; i < count; ++i) {
    double x = u.data[i * u.stride], y = v.data[i * v.stride];
    const bool there = wrapped(x, opened.wrap_u) && wrapped(y, opened.wrap_v);
    values.data[i * values.stride] = there ? opened.picture.at(channel, x, y) : 0;
  }
  return BURIN_OK;
}

burin_status sample_area(const burin_host* host, burin_stamp stamp, std::uint32_t channel,
                         std::uint32_t count, burin_floats u, burin_floats v, const burin_stamp_area*,
                         burin_floats_out values) {
  return sample_stamp(host, stamp, channel, count, u, v, values);
}

burin_status set_text(const burin_host* host, const char* font, const char* text, std::uint32_t em,
                      burin_stamp* stamp, burin_lettering_info* info, burin_text* error) {
  if (std::string_view(font) != "DejaVuSans.ttf") {
    write(error, std::string("no font '") + font + "'");
    return BURIN_NOT_FOUND;
  }
  const float width = TestHost::letter_width * static_cast<float>(std::string_view(text).size());
  const float top = 1, bottom = -0.5f;
  *info = {sizeof *info, width, TestHost::ascent, TestHost::descent, 0, width, bottom, top};
  const auto at = [=](std::uint32_t, double u, double v) {
    const double x = u * width, letter = std::floor(x / TestHost::letter_width);
    return TestHost::letter(x - letter * TestHost::letter_width, top - v * (top - bottom));
  };
  const auto texels = static_cast<std::uint32_t>(width * static_cast<float>(em));
  self(host).stamps.push_back({{texels, em, 1, at}, BURIN_WRAP_BLACK, BURIN_WRAP_BLACK});
  ++self(host).open_stamps;
  stamp->handle = first_handle + self(host).stamps.size() - 1;
  return BURIN_OK;
}

burin_floats uniform(const float& value) { return {&value, 0, 0}; }

burin_vectors vectors(const std::vector<Vector>& values) {
  if (values.empty()) return {};
  return {{&values[0].x, 3, 0}, {&values[0].y, 3, 0}, {&values[0].z, 3, 0}};
}

burin_param_value default_value(const burin_param_info& info) {
  burin_param_value value{};
  value.number = {&info.default_number, 0, 0};
  for (std::size_t i = 0; i < 4; ++i) value.colour[i] = {&info.default_colour[i], 0, 0};
  const char* text = info.type == BURIN_PARAM_TEXT ? info.default_text : info.default_file;
  value.text = text ? text : "";
  value.knots = info.default_knots;
  value.knot_count = info.default_knot_count;
  return value;
}

}  // namespace

PluginModule::PluginModule(const std::string& name)
    : path(std::string(BURIN_BIN_FOLDER "/") + name + ".burin"),
      handle_(dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL)) {
  if (!handle_) throw std::runtime_error(dlerror());
  entry_ = static_cast<const burin_plugin_entry*>(dlsym(handle_, BURIN_PLUGIN_SYMBOL));
  if (!entry_) throw std::runtime_error(dlerror());
  if (entry_->init(path.c_str(), nullptr) != BURIN_OK) throw std::runtime_error(path + ": init failed");
}

PluginModule::~PluginModule() {
  entry_->deinit();
  dlclose(handle_);
}

const burin_brush_factory& PluginModule::factory() const {
  return *static_cast<const burin_brush_factory*>(entry_->get_factory(BURIN_BRUSH_FACTORY));
}

const burin_brush_descriptor& PluginModule::descriptor(std::string_view id) const {
  for (std::uint32_t i = 0; i < factory().brush_count; ++i)
    if (factory().brushes[i]->id == id) return *factory().brushes[i];
  throw std::runtime_error(path + ": no brush " + std::string(id));
}

TestHost::TestHost() {
  log_ = {sizeof(burin_log), 0, write_line};
  stamps_ = {sizeof(burin_stamps), 0, open_stamp, close_stamp, sample_stamp, open_with, sample_area};
  lettering_ = {sizeof(burin_lettering), 0, set_text};
  pictures["ramp.exr"] = {64, 32, 1, [](std::uint32_t, double u, double v) { return ramp(u, v); }};
  abi = {sizeof(burin_host), BURIN_ABI_MAJOR, BURIN_ABI_MINOR, 0, this, "test", "1.0", nullptr};
  abi.get_extension = [](const burin_host* host, const char* id) -> const void* {
    TestHost& test = self(host);
    test.log_.struct_size = test.log_struct_size;
    if (test.withholds_services) return nullptr;
    if (std::string_view(id) == BURIN_EXT_LOG) return &test.log_;
    if (std::string_view(id) == BURIN_EXT_STAMPS) return &test.stamps_;
    if (std::string_view(id) == BURIN_EXT_LETTERING) return &test.lettering_;
    return nullptr;
  };
}

float TestHost::ramp(double u, double v) {
  return static_cast<float>((u - std::floor(u)) + 2 * (v - std::floor(v)));
}

float TestHost::letter(double x, double y) {
  const bool stem = x >= 0 && x <= 0.15 && y >= 0 && y <= 0.7;
  const bool foot = x >= 0 && x <= 0.5 && y >= 0 && y <= 0.15;
  return stem || foot ? 1.0f : 0.0f;
}

ParamSnapshot::ParamSnapshot(const burin_brush_descriptor& descriptor) : descriptor_(descriptor) {
  for (std::uint32_t i = 0; i < descriptor.param_count; ++i)
    values_.push_back(default_value(*descriptor.params[i]));
}

void ParamSnapshot::set(std::string_view id, std::vector<float> numbers, std::uint32_t stride) {
  auto& kept = numbers_[std::string(id)] = std::move(numbers);
  value(id).number = {kept.data(), stride, 0};
}

void ParamSnapshot::set_file(std::string_view id, std::string file) {
  value(id).text = (files_[std::string(id)] = std::move(file)).c_str();
}

burin_param_value& ParamSnapshot::value(std::string_view id) {
  for (std::uint32_t i = 0; i < descriptor_.param_count; ++i)
    if (descriptor_.params[i]->id == id) return values_[i];
  throw std::runtime_error("no parameter " + std::string(id));
}

burin_params ParamSnapshot::abi() const {
  return {sizeof(burin_params), static_cast<std::uint32_t>(values_.size()), values_.data()};
}

StrokeDriver::StrokeDriver(const PluginModule& module, const char* brush_id, const burin_host& host)
    : params(module.descriptor(brush_id)), descriptor_(module.descriptor(brush_id)) {
  context.struct_size = sizeof context;
  context.length = 10;
  context.radius_min = context.radius_max = 1;
  context.object_scale = 100;
  brush_ = module.factory().create(&module.factory(), &host, brush_id, nullptr);
  if (!brush_) throw std::runtime_error("no brush " + std::string(brush_id));
}

StrokeDriver::~StrokeDriver() {
  end();
  brush_->destroy(brush_);
}

Answer StrokeDriver::begin() {
  std::string line(text_capacity, '\0');
  burin_text text{sizeof text, text_capacity, line.data()};
  plan = {sizeof plan, 1, 0};
  burin_stroke_context empty = context;
  empty.length = 0;
  const burin_params values = params.abi();
  const burin_status status = brush_->begin(brush_, &empty, &values, &plan, &stroke_, &text);
  open_ = status == BURIN_OK;
  return {status, line.c_str()};
}

void StrokeDriver::end() {
  if (open_) brush_->end(brush_, stroke_);
  open_ = false;
}

/// The input of a stroke that is longer than twice its brush's end influence.
std::vector<float> StrokeDriver::end_distances(const Nodes& nodes) const {
  std::vector<float> distances;
  const auto length = static_cast<float>(context.length), most = static_cast<float>(plan.end_influence);
  const bool has_ends = !(context.flags & (BURIN_STROKE_CLOSED | BURIN_STROKE_DAB));
  for (const float t : nodes.t)
    distances.push_back(has_ends ? std::clamp(std::min(t, length - t), 0.0f, most) : most);
  return distances;
}

Answer StrokeDriver::evaluate(const Nodes& nodes) {
  std::string line(text_capacity, '\0');
  burin_text text{sizeof text, text_capacity, line.data()};
  const burin_params values = params.abi();
  const std::uint64_t read = descriptor_.inputs_read, written = descriptor_.outputs_written;

  burin_batch batch{};
  batch.struct_size = sizeof batch;
  batch.count = static_cast<std::uint32_t>(nodes.t.size());
  batch.params = &values;
  if (read & BURIN_INPUT_T) batch.t = {nodes.t.data(), 1, 0};
  if (read & BURIN_INPUT_D) batch.d = {nodes.d.data(), 1, 0};
  if (read & BURIN_INPUT_RADIUS) batch.radius = uniform(nodes.radius);
  if (!nodes.radii.empty()) batch.radius = {nodes.radii.data(), 1, 0};
  if (read & BURIN_INPUT_STRETCH) batch.stretch = uniform(nodes.stretch);
  if (read & BURIN_INPUT_FOOTPRINT) batch.footprint_t = uniform(nodes.footprint_t);
  if (read & BURIN_INPUT_FOOTPRINT) batch.footprint_d = uniform(nodes.footprint_d);
  if (read & BURIN_INPUT_POSITION) batch.position = vectors(nodes.position);
  if (read & BURIN_INPUT_NORMAL) batch.normal = vectors(nodes.normal);
  if (read & BURIN_INPUT_E1) batch.e1 = vectors(nodes.e1);
  if (read & BURIN_INPUT_LAPLACIAN) batch.laplacian = vectors(nodes.laplacian);
  if (read & BURIN_INPUT_DISPLACEMENT) batch.displacement = vectors(nodes.displacement);
  if (read & BURIN_INPUT_FOOT) batch.foot = vectors(nodes.foot);
  if (read & BURIN_INPUT_FOOT) batch.foot_normal = vectors(nodes.foot_normal);
  if (read & BURIN_INPUT_FINE_POSITION) batch.fine_position = vectors(nodes.fine_position);

  const std::vector<float> end_distance = end_distances(nodes);
  if (read & BURIN_INPUT_END_DISTANCE) batch.end_distance = {end_distance.data(), 1, 0};

  burin_outputs outputs{};
  outputs.struct_size = sizeof outputs;
  outputs.count = batch.count;
  const auto offer = [&](std::uint64_t output, std::vector<float>& array,
                         float before = 0) -> burin_floats_out {
    array.assign(nodes.t.size(), before);
    return {written & output ? array.data() : nullptr, 1, 0};
  };
  outputs.along = offer(BURIN_OUTPUT_DISPLACEMENT, along);
  outputs.across = offer(BURIN_OUTPUT_DISPLACEMENT, across);
  outputs.up = offer(BURIN_OUTPUT_DISPLACEMENT, up);
  outputs.mask = offer(BURIN_OUTPUT_MASK, mask, mask_before);
  for (std::size_t i = 0; i < 4; ++i)
    outputs.colour[i] = offer(BURIN_OUTPUT_COLOUR, colour[i], colour_before[i]);

  const burin_status status = brush_->evaluate(brush_, stroke_, &context, &batch, &outputs, &text);
  return {status, line.c_str()};
}

}  // namespace burin::test
