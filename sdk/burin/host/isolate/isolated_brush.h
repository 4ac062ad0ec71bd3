#pragma once
#include <burin/abi/ext/curve_filter.h>
#include <burin/abi/ext/state.h>
#include <burin/abi/ext/volume.h>
#include <burin/host/isolate/brush_process.h>

#include <memory>
#include <mutex>
#include <string>

namespace burin::isolate {

/// What a brush in a process of its own is made of.
struct BrushOrigin {
  std::filesystem::path module;
  std::string brush;  ///< id
  Bytes descriptors;  ///< message of the module's descriptors, which must be the same in every process
  Isolation isolation;
  Log log;
};

/// A burin_brush whose functions ask a process. Another process is started when a stroke begins after the one
/// before has failed; it gets the state that the brush had after its last whole stroke. The ABI's destroy()
/// frees the object.
class IsolatedBrush {
 public:
  /// Starts the process. Throws Error if the brush cannot be created in it.
  explicit IsolatedBrush(BrushOrigin origin);
  IsolatedBrush(const IsolatedBrush&) = delete;
  IsolatedBrush& operator=(const IsolatedBrush&) = delete;

  const burin_brush* abi() const { return &brush_; }
  static IsolatedBrush& of(const burin_brush* brush) { return *static_cast<IsolatedBrush*>(brush->self); }

  // What the functions of the ABI's tables do; they throw Error.
  const void* extension(std::string_view id) const;
  void* begin(const burin_stroke_context& context, const burin_params& params, burin_stroke_plan& plan);
  void run(void* stroke, BatchCall& call);
  void end(void* stroke);
  burin_curve_reach reach(void* stroke, const burin_curve_reach& reach);
  void filter(void* stroke, const burin_stroke_context& context, const burin_curve_points& points,
              burin_floats_out along, burin_floats_out across);
  burin_solid_plan plan(void* stroke, const burin_stroke_context& context, const burin_solid_plan& plan);
  Bytes save(std::uint32_t& version);
  void load(std::uint32_t version, std::span<const std::byte> state);

 private:
  /// A stroke, and the process that has it. The ABI's void* points to one.
  struct Stroke {
    std::shared_ptr<BrushProcess> process;
    std::uint32_t number;
  };

  void start();
  void restore_state(BrushProcess& process);
  BrushProcess& running();
  Answer ask(BrushProcess& process, Request what, const MessageWriter& content);
  void keep_state(MessageReader& from);

  burin_brush brush_;
  burin_state state_table_;
  BrushOrigin origin_;
  /// Of calls that are not for batches, and of all members below.
  std::mutex mutex_;
  std::shared_ptr<BrushProcess> process_;
  std::atomic<std::uint32_t> offers_ = 0;
  std::uint32_t strokes_ = 0, state_version_ = 0;
  std::optional<Bytes> state_;          ///< after the last whole stroke, of `state_version_`
  std::atomic<bool> doubtful_ = false;  ///< a call of the brush has failed
};

}  // namespace burin::isolate
