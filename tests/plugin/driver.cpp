#include "driver.h"

#include <dlfcn.h>

#include <cmath>
#include <stdexcept>

namespace burin::test {

namespace {

const std::string_view ramp_file = "ramp.exr";
constexpr std::uint64_t ramp_handle = 7;

TestHost& self(const burin_host* host) { return *static_cast<TestHost*>(host->self); }

void write_line(const burin_host* host, burin_log_severity severity, const char* line) {
  self(host).lines.emplace_back(severity, line);
}

void write(burin_text* text, const std::string& line) {
  const std::size_t size = line.copy(text->data, text->capacity - 1);
  text->data[size] = '\0';
}

burin_status open_stamp(const burin_host* host, const char* path, burin_stamp* stamp, burin_stamp_info* info,
                        burin_text* error) {
  if (path != ramp_file) {
    write(error, std::string(path) + ": no such file");
    return BURIN_NOT_FOUND;
  }
  ++self(host).open_stamps;
  stamp->handle = ramp_handle;
  *info = {sizeof(burin_stamp_info), 64, 32, 1, 0, 3, BURIN_WRAP_PERIODIC, BURIN_WRAP_PERIODIC};
  return BURIN_OK;
}

void close_stamp(const burin_host* host, burin_stamp stamp) {
  if (stamp.handle != ramp_handle) throw std::logic_error("a stamp is closed that was not open");
  --self(host).open_stamps;
}

burin_status sample_stamp(const burin_host*, burin_stamp stamp, std::uint32_t channel, std::uint32_t count,
                          burin_floats u, burin_floats v, burin_floats_out values) {
  if (stamp.handle != ramp_handle || channel > 0) return BURIN_INVALID_ARGUMENT;
  for (std::uint32_t i = 0; i < count; ++i)
    values.data[i * values.stride] = TestHost::ramp(u.data[i * u.stride], v.data[i * v.stride]);
  return BURIN_OK;
}

burin_status open_with(const burin_host* host, const char* path, const burin_stamp_options*,
                       burin_stamp* stamp, burin_stamp_info* info, burin_text* error) {
  return open_stamp(host, path, stamp, info, error);
}

/// The ramp is linear, so a mean over a small area within a period is its value in the middle.
burin_status sample_area(const burin_host* host, burin_stamp stamp, std::uint32_t channel,
                         std::uint32_t count, burin_floats u, burin_floats v, const burin_stamp_area*,
                         burin_floats_out values) {
  return sample_stamp(host, stamp, channel, count, u, v, values);
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
    : path(std::string(BURIN_BIN_FOLDER) + "/" + name + ".burin"),
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
  abi = {sizeof(burin_host), BURIN_ABI_MAJOR, BURIN_ABI_MINOR, 0, this, "test", "1.0", nullptr};
  abi.get_extension = [](const burin_host* host, const char* id) -> const void* {
    TestHost& test = self(host);
    test.log_.struct_size = test.log_struct_size;
    if (test.withholds_services) return nullptr;
    if (std::string_view(id) == BURIN_EXT_LOG) return &test.log_;
    if (std::string_view(id) == BURIN_EXT_STAMPS) return &test.stamps_;
    return nullptr;
  };
}

float TestHost::ramp(double u, double v) {
  return static_cast<float>((u - std::floor(u)) + 2 * (v - std::floor(v)));
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
  if (read & BURIN_INPUT_FOOTPRINT) batch.footprint_t = uniform(nodes.footprint_t);
  if (read & BURIN_INPUT_FOOTPRINT) batch.footprint_d = uniform(nodes.footprint_d);
  if (read & BURIN_INPUT_POSITION) batch.position = vectors(nodes.position);
  if (read & BURIN_INPUT_NORMAL) batch.normal = vectors(nodes.normal);
  if (read & BURIN_INPUT_E1) batch.e1 = vectors(nodes.e1);
  if (read & BURIN_INPUT_LAPLACIAN) batch.laplacian = vectors(nodes.laplacian);
  if (read & BURIN_INPUT_DISPLACEMENT) batch.displacement = vectors(nodes.displacement);
  if (read & BURIN_INPUT_FOOT) batch.foot = vectors(nodes.foot);
  if (read & BURIN_INPUT_FOOT) batch.foot_normal = vectors(nodes.foot_normal);

  burin_outputs outputs{};
  outputs.struct_size = sizeof outputs;
  outputs.count = batch.count;
  const auto offer = [&](std::uint64_t output, std::vector<float>& array) -> burin_floats_out {
    array.assign(nodes.t.size(), 0);
    return {written & output ? array.data() : nullptr, 1, 0};
  };
  outputs.along = offer(BURIN_OUTPUT_DISPLACEMENT, along);
  outputs.across = offer(BURIN_OUTPUT_DISPLACEMENT, across);
  outputs.up = offer(BURIN_OUTPUT_DISPLACEMENT, up);
  outputs.mask = offer(BURIN_OUTPUT_MASK, mask);
  for (std::size_t i = 0; i < 4; ++i) outputs.colour[i] = offer(BURIN_OUTPUT_COLOUR, colour[i]);

  const burin_status status = brush_->evaluate(brush_, stroke_, &context, &batch, &outputs, &text);
  return {status, line.c_str()};
}

}  // namespace burin::test
