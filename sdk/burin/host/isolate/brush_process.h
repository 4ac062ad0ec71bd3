#pragma once
#include <burin/host/brush_library.h>
#include <burin/host/isolate/child_process.h>
#include <burin/host/isolate/lane_batch.h>

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace burin::isolate {

using Log = BrushLibrary::Log;

/// What a process answers.
class Answer {
 public:
  /// Throws Error if the bytes are no answer.
  explicit Answer(Bytes bytes);

  burin_status status() const { return status_; }
  const std::string& text() const { return text_; }

  /// What comes with it. The answer must outlive the reader.
  MessageReader content() const { return MessageReader(std::span(bytes_).subspan(begin_)); }

 private:
  Bytes bytes_;
  burin_status status_;
  std::string text_;
  std::size_t begin_;
};

/// A running burin-brush-process as the host sees it. Once it has failed it is gone, and every call throws
/// Error with the reason. The destructor lets it end by itself for a second, then kills it.
class BrushProcess {
 public:
  /// Throws FileError if the program cannot be started.
  BrushProcess(const Isolation& isolation, Log log);
  BrushProcess(const BrushProcess&) = delete;
  BrushProcess& operator=(const BrushProcess&) = delete;
  ~BrushProcess();

  /// Sends a request and waits for the answer. One thread at a time. `seconds`: what it may take.
  Answer request(Request what, const MessageWriter& content, double seconds);

  /// Asks for elements [first, first + count) of a call, which fit a lane. Throws Error if the brush refuses
  /// or the process fails. Any thread, also several at once.
  void run(const BatchCall& call, std::size_t first, std::size_t count);

  /// The threads of the lanes, as the process told them once it had created its brush.
  void set_lane_threads(std::vector<pid_t> threads) { lane_threads_ = std::move(threads); }

  bool has_failed() const { return failed_; }

  /// Whether the process is there, as far as the system knows: it may have ended between two calls.
  bool is_running() const { return !failed_ && process_->running(); }

  /// Why it has failed; one line.
  std::string failure() const;
  std::size_t lane_count() const { return lanes_; }

 private:
  class LaneHold;

  bool wait_for(short events, Clock::time_point deadline);
  void wait_for_turn(LaneCall& lane, std::size_t index);
  [[noreturn]] void fail(std::optional<double> late_after, pid_t thread);
  std::string reason(std::optional<double> late_after, pid_t thread);
  void drain_log();

  int processor_of(std::size_t lane) const { return processors_[lane % processors_.size()]; }
  SharedHeader& header() const { return *reinterpret_cast<SharedHeader*>(memory_); }
  std::byte* lane(std::size_t index) const { return memory_ + header_bytes + index * lane_bytes; }

  Isolation isolation_;
  Log log_;
  std::vector<int> processors_;  ///< that this process may run on
  std::size_t lanes_;
  std::byte* memory_ = nullptr;
  Descriptor socket_, life_, log_socket_;
  std::optional<ChildProcess> process_;
  std::vector<pid_t> lane_threads_;

  std::mutex lane_mutex_;
  std::condition_variable lane_freed_;
  std::vector<std::size_t> free_lanes_;

  std::atomic<bool> failed_ = false;
  mutable std::mutex failure_mutex_;
  std::string failure_;
  std::mutex log_mutex_;
  std::atomic<std::uint32_t> lines_logged_ = 0;
};

}  // namespace burin::isolate
