#pragma once
#include <burin/abi/ext/log.h>
#include <burin/abi/ext/stamps.h>
#include <burin/abi/plugin.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Drives plugin modules through the C ABI, as a host does.
namespace burin::test {

/// A module below the build's bin folder, loaded and initialised while the object lives.
class PluginModule {
 public:
  explicit PluginModule(const std::string& name);
  PluginModule(const PluginModule&) = delete;
  PluginModule& operator=(const PluginModule&) = delete;
  ~PluginModule();

  const std::string path;
  const burin_plugin_entry& entry() const { return *entry_; }
  const burin_brush_factory& factory() const;
  const burin_brush_descriptor& descriptor(std::string_view id) const;

 private:
  void* handle_;
  const burin_plugin_entry* entry_;
};

/// A host with both services, unless told to withhold them. Its stamps know one file, "ramp.exr": 64 x 32
/// texels, at (u, v) the value fraction(u) + 2 fraction(v).
class TestHost {
 public:
  TestHost();
  TestHost(const TestHost&) = delete;
  TestHost& operator=(const TestHost&) = delete;

  static float ramp(double u, double v);

  burin_host abi;
  bool withholds_services = false;
  std::uint32_t log_struct_size = sizeof(burin_log);
  std::vector<std::pair<burin_log_severity, std::string>> lines;
  int open_stamps = 0;

 private:
  burin_log log_;
  burin_stamps stamps_;
};

/// Parameter values, at first the defaults of the descriptor.
class ParamSnapshot {
 public:
  explicit ParamSnapshot(const burin_brush_descriptor& descriptor);

  void set(std::string_view id, float number) { set(id, std::vector<float>{number}, 0); }
  void set(std::string_view id, std::vector<float> numbers, std::uint32_t stride);
  void set_file(std::string_view id, std::string file);
  burin_param_value& value(std::string_view id);
  burin_params abi() const;

 private:
  const burin_brush_descriptor& descriptor_;
  std::vector<burin_param_value> values_;
  std::map<std::string, std::vector<float>, std::less<>> numbers_;
  std::map<std::string, std::string, std::less<>> files_;
};

struct Vector {
  float x, y, z;
};

/// The chart nodes to evaluate. What a brush reads must be there, an element a node.
struct Nodes {
  std::vector<float> t, d;
  float radius = 1;  ///< of all nodes, unless `radii` has one for each
  std::vector<float> radii{};
  float footprint_t = 0.01f, footprint_d = 0.01f;
  std::vector<Vector> position{}, normal{}, e1{}, laplacian{}, displacement{}, foot{}, foot_normal{};
};

/// What a call answered.
struct Answer {
  burin_status status;
  std::string text;
};

/// A brush and a stroke of it.
class StrokeDriver {
 public:
  StrokeDriver(const PluginModule& module, const char* brush_id, const burin_host& host);
  StrokeDriver(const StrokeDriver&) = delete;
  StrokeDriver& operator=(const StrokeDriver&) = delete;
  ~StrokeDriver();

  /// Set before use.
  ParamSnapshot params;
  burin_stroke_context context{};  ///< of a stroke of radius 1 and length 10, not finished
  std::uint32_t text_capacity = 200;

  Answer begin();
  void end();

  /// Evaluates all nodes in one batch; results in along, across, up, mask and colour.
  Answer evaluate(const Nodes& nodes);
  std::vector<float> along, across, up, mask;
  std::array<std::vector<float>, 4> colour;

  burin_stroke_plan plan{};

 private:
  const burin_brush_descriptor& descriptor_;
  const burin_brush* brush_;
  void* stroke_ = nullptr;
  bool open_ = false;
};

}  // namespace burin::test
