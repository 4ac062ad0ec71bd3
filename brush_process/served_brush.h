#pragma once
#include <burin/abi/ext/curve_filter.h>
#include <burin/abi/ext/state.h>
#include <burin/abi/ext/volume.h>
#include <burin/host/isolate/channel.h>
#include <burin/host/isolate/shared_memory.h>
#include <burin/host/isolate/stroke_message.h>
#include <burin/host/plugin/plugin_module.h>

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace burin::process {

/// The status and text of a call of the brush, and what it gave.
struct Reply {
  burin_status status = BURIN_OK;
  std::string text;
  isolate::MessageWriter content;
};

/// A brush and its open strokes. evaluate() may run on several threads at once, also during the other calls.
class ServedBrush {
 public:
  /// Loads the module and creates the brush. Throws Error if that fails.
  ServedBrush(const std::filesystem::path& module, const std::string& id, const burin_host& host);
  ServedBrush(const ServedBrush&) = delete;
  ServedBrush& operator=(const ServedBrush&) = delete;
  ~ServedBrush();

  /// The answer to Request::create without the threads: what it offers, the version of its state.
  isolate::MessageWriter offer() const;
  const PluginModule& module() const { return module_; }

  /// Answers a request but create and quit.
  Reply answer(isolate::Request what, isolate::MessageReader from);

  /// Answers a call of a lane, which begins at `lane`.
  void answer(std::byte* lane);

 private:
  /// An open stroke. Batches have its texts and curves, which are too large for a lane.
  struct Stroke {
    explicit Stroke(isolate::MessageReader& from) : params(from) {}
    isolate::ReceivedParams params;
    void* handle = nullptr;
  };

  /// A call of the host. It alone knows that one call has ended before another began, perhaps on another
  /// thread: the counter makes what the first has written visible to the second.
  class Call {
   public:
    explicit Call(std::atomic<std::uint32_t>& calls) : calls_(calls) { ++calls_; }
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;
    ~Call() { ++calls_; }

   private:
    std::atomic<std::uint32_t>& calls_;
  };

  Stroke& stroke(std::uint32_t number);
  Reply begin(isolate::MessageReader& from);
  Reply end(isolate::MessageReader& from);
  Reply reach(isolate::MessageReader& from);
  Reply filter(isolate::MessageReader& from);
  Reply plan(isolate::MessageReader& from);
  Reply save();
  Reply load(isolate::MessageReader& from);

  PluginModule module_;
  const burin_brush* brush_;
  const burin_state* state_ = nullptr;
  const burin_curve_filter* filter_ = nullptr;
  const burin_volume* volume_ = nullptr;
  std::atomic<std::uint32_t> calls_{0};
  std::mutex mutex_;  ///< of strokes_
  std::map<std::uint32_t, Stroke> strokes_;
  isolate::Bytes told_state_;  ///< that the host knows
  bool state_told_ = false;
};

}  // namespace burin::process
