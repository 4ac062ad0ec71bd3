#pragma once
#include <burin/abi/ext/lettering.h>
#include <burin/abi/ext/log.h>
#include <burin/abi/ext/stamps.h>
#include <burin/abi/plugin.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
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

/// An image of a TestHost: its value at (u, v) in 0..1.
struct TestPicture {
  std::uint32_t width, height, channels;
  std::function<float(std::uint32_t channel, double u, double v)> at;
};

/// A host with all services, unless told to withhold them. Its stamps know "ramp.exr", 64 x 32 texels, at
/// (u, v) the value fraction(u) + 2 fraction(v), and what tests add; they take no means. It sets text in one
/// font, "DejaVuSans.ttf", and every character as an L, see `letter`.
class TestHost {
 public:
  TestHost();
  TestHost(const TestHost&) = delete;
  TestHost& operator=(const TestHost&) = delete;

  static float ramp(double u, double v);

  /// 1 inside of the L that stands at x = 0, ems: 0.7 high, 0.5 wide, its strokes 0.15 thick.
  static float letter(double x, double y);
  static constexpr float letter_width = 0.6f, ascent = 0.9f, descent = 0.3f;  ///< ems

  burin_host abi;
  bool withholds_services = false;
  std::uint32_t log_struct_size = sizeof(burin_log);
  std::vector<std::pair<burin_log_severity, std::string>> lines;
  int open_stamps = 0;
  std::map<std::string, TestPicture> pictures;

  struct Stamp {
    TestPicture picture;
    burin_stamp_wrap wrap_u, wrap_v;
  };
  std::vector<Stamp> stamps;  ///< all that were ever opened; handle - 7

 private:
  burin_log log_;
  burin_stamps stamps_;
  burin_lettering lettering_;
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
  float footprint_t = 0.01f, footprint_d = 0.01f, stretch = 1;
  std::vector<Vector> position{}, normal{}, e1{}, laplacian{}, displacement{}, foot{}, foot_normal{},
      fine_position{};
};

/// The result of a call.
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
  float mask_before = 1;
  std::array<float, 4> colour_before{1, 1, 1, 1};

  burin_stroke_plan plan{};

 private:
  std::vector<float> end_distances(const Nodes& nodes) const;

  const burin_brush_descriptor& descriptor_;
  const burin_brush* brush_;
  void* stroke_ = nullptr;
  bool open_ = false;
};

}  // namespace burin::test
