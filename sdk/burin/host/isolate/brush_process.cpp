// The host's side of a brush in a process of its own.
//
// Shared: a memfd that is sealed against a change of its size, with a header and one lane for each thread of
// the machine (shared_memory.h). The host lays every array out, remembers where, and copies results out of
// it before it looks at them; of what the process writes it believes nothing: texts are cut and cleaned,
// messages are read with bounds (message.h), descriptors are checked as those of a module.
//
// Owned by the host: the process, a stream socket, the memory, the writing end of a pipe that nothing is
// written to, and a datagram socket for lines of the log. By the process: the module, the brush, its strokes,
// and services of its own that read the same files.
//
// Order of messages: describe; or create, then begin, batches, end and so on as burin/abi/brush.h allows,
// then quit. Each request through the socket has one answer. A batch goes through a lane: the host fills it,
// passes the turn, and sleeps on a futex until the turn comes back. As many threads as there are lanes do so
// at once; others wait for a lane. The threads of lanes stay on one processor each, two on each; a host's
// thread takes a lane of the processor it runs on, whose thread takes its place while it sleeps. To wake a
// thread elsewhere, or to wait awake, takes several times as long.
//
// Failures. The process crashes or calls exit(): its handlers note where in the header, it ends, and the host
// sees its end within 5 ms. It hangs: at the deadline the host interrupts the thread, which notes where it
// is, and kills it. It takes too much memory: allocations fail beyond RLIMIT_AS, which the brush reports or
// crashes by. In all cases the host keeps one line with the reason, every waiting thread throws it, and
// nothing is left: the process is waited for, the memory has no name. The stroke fails as any stroke whose
// brush reports an error, and IsolatedBrush starts another process for the next. The host dies: the kernel
// kills the process, since the pipe has no writer any more.
#if defined(__linux__)
#include <burin/abi/ext/log.h>
#include <burin/base/program_file.h>
#include <burin/host/isolate/brush_process.h>
#include <burin/plugin/detail/error.h>
#include <burin/version.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>

namespace burin::isolate {
namespace {

/// How often a waiting thread looks whether the process is there still, nanoseconds.
constexpr std::uint64_t look = 5'000'000;

/// How long a process may take to tell where it crashed or hangs, seconds.
constexpr double time_to_tell = 0.3;

[[noreturn]] void fail_to(const char* what) {
  throw Error(fmt::format("a brush's process cannot {}: {}", what, std::strerror(errno)));
}

std::byte* map_memory(const Descriptor& file, std::size_t bytes) {
  if (file.number() < 0 || ftruncate(file.number(), static_cast<off_t>(bytes)) != 0) fail_to("share memory");
  // Else a process that shrinks it would crash the host.
  if (fcntl(file.number(), F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL) != 0)
    fail_to("share memory");
  void* memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file.number(), 0);
  if (memory == MAP_FAILED) fail_to("share memory");
  return static_cast<std::byte*>(memory);
}

/// Two ends of a socket or pipe: the host's and the process's.
struct Ends {
  Descriptor host, process;
};

Ends socket_ends(int type) {
  int ends[2];
  if (socketpair(AF_UNIX, type | SOCK_CLOEXEC, 0, ends) != 0) fail_to("be reached");
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

Ends pipe_ends() {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) fail_to("be reached");
  return {Descriptor(ends[1]), Descriptor(ends[0])};
}

/// The processors that this process may run on, at least one.
std::vector<int> own_processors() {
  cpu_set_t set;
  CPU_ZERO(&set);
  std::vector<int> processors;
  if (sched_getaffinity(getpid(), sizeof set, &set) == 0)
    for (int i = 0; i < CPU_SETSIZE; ++i)
      if (CPU_ISSET(static_cast<std::size_t>(i), &set)) processors.push_back(i);
  if (processors.empty()) processors.push_back(0);
  return processors;
}

std::string signal_name(int signal) {
  switch (signal) {
    case SIGSEGV:
      return "segmentation fault";
    case SIGBUS:
      return "bus error";
    case SIGFPE:
      return "arithmetic error";
    case SIGILL:
      return "illegal instruction";
    case SIGABRT:
      return "abort";
    default:
      return fmt::format("signal {}", signal);
  }
}

/// A text of fixed room that the other process may be writing to.
template <std::size_t size>
std::string text_of(const char (&shared)[size]) {
  char copy[size];
  std::memcpy(copy, shared, size);
  return shown_text(
      std::string_view(copy, static_cast<std::size_t>(std::find(copy, copy + size, '\0') - copy)), 200);
}

/// " in FUNCTION, PLACE"; empty if neither is known.
std::string where(const CrashRecord& record) {
  const std::string readable = text_of(record.readable), place = text_of(record.place);
  const std::string function = readable.empty() ? text_of(record.function) : readable;
  if (function.empty()) return place.empty() ? "" : " at " + place;
  return fmt::format(" in {}, {}", function, place);
}

/// Whether the signal comes with the address that was accessed.
bool has_address(int signal, int code) { return (signal == SIGSEGV || signal == SIGBUS) && code > 0; }

std::string crash_text(const CrashRecord& record) {
  const int signal = record.signal, code = record.code;
  if (signal == 0) return fmt::format("called exit({}){}", code, where(record));
  const std::string address =
      has_address(signal, code) ? fmt::format(" at address {:#x}", record.address) : std::string();
  return fmt::format("crashed: {}{}{}", signal_name(signal), address, where(record));
}

}  // namespace

Answer::Answer(Bytes bytes) : bytes_(std::move(bytes)) {
  MessageReader reader{bytes_};
  status_ = reader.value<burin_status>();
  text_ = shown_text(reader.text());
  begin_ = bytes_.size() - reader.left();
}

BrushProcess::BrushProcess(const Isolation& isolation, Log log)
    : isolation_(isolation),
      log_(std::move(log)),
      processors_(own_processors()),
      lanes_(std::min(2 * processors_.size(), most_lanes)) {
  const std::filesystem::path program =
      isolation.program.empty() ? beside_own_file("burin-brush-process") : isolation.program;
  const Descriptor file(memfd_create("burin-brush", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  Ends socket = socket_ends(SOCK_STREAM), log_socket = socket_ends(SOCK_SEQPACKET), life = pipe_ends();
  memory_ = map_memory(file, shared_bytes(lanes_));
  header().lanes = static_cast<std::uint32_t>(lanes_);
  header().memory = isolation.memory;
  for (std::size_t i = 0; i < lanes_; ++i) {
    free_lanes_.push_back(i);
    header().processors[i] = processor_of(i);
  }
  try {
    process_.emplace(program, BURIN_VERSION,
                     std::array{socket.process.number(), file.number(), life.process.number(),
                                log_socket.process.number()});
  } catch (...) {
    munmap(memory_, shared_bytes(lanes_));
    throw;
  }
  socket_ = std::move(socket.host);
  life_ = std::move(life.host);
  log_socket_ = std::move(log_socket.host);
}

BrushProcess::~BrushProcess() {
  try {
    if (!failed_) {
      request(Request::quit, {}, 1);
      process_->wait(deadline_in(1));
    }
  } catch (const std::exception& error) {
    if (log_) log_(BURIN_LOG_WARNING, error.what());
  }
  drain_log();
  process_.reset();
  munmap(memory_, shared_bytes(lanes_));
}

/// Waits until the socket is ready for `events`; false if the process has ended or the time is over.
bool BrushProcess::wait_for(short events, Clock::time_point deadline) {
  std::array<pollfd, 2> watched{{{socket_.number(), events, 0}, {process_->descriptor(), POLLIN, 0}}};
  while (Clock::now() < deadline) {
    if (poll(watched.data(), watched.size(), poll_time(deadline)) <= 0) continue;
    // What the process sent before its end is read first.
    return (watched[0].revents & events) != 0;
  }
  return false;
}

Answer BrushProcess::request(Request what, const MessageWriter& content, double seconds) {
  if (failed_) fail({}, 0);
  MessageWriter message;
  message.value(what).block(content.bytes());
  const Clock::time_point deadline = deadline_in(seconds);
  Bytes answer;
  const bool answered =
      send_message(socket_.number(), message.bytes(), [&] { return wait_for(POLLOUT, deadline); }) &&
      receive_message(socket_.number(), answer, [&] { return wait_for(POLLIN, deadline); });
  drain_log();
  if (!answered) fail(Clock::now() >= deadline ? std::optional(seconds) : std::nullopt, 0);
  try {
    return Answer(std::move(answer));
  } catch (const Error&) {
    fail({}, 0);
  }
}

/// Takes a lane that no other thread uses, waits for one if need be, and gives it back.
class BrushProcess::LaneHold {
 public:
  explicit LaneHold(BrushProcess& process) : process_(process) {
    std::unique_lock lock(process.lane_mutex_);
    process.lane_freed_.wait(lock, [&] { return !process.free_lanes_.empty(); });
    std::vector<std::size_t>& free = process.free_lanes_;
    const int here = sched_getcpu();
    const auto near =
        std::ranges::find(free, here, [&](std::size_t lane) { return process.processor_of(lane); });
    const auto chosen = near == free.end() ? free.end() - 1 : near;
    index_ = *chosen;
    free.erase(chosen);
  }
  LaneHold(const LaneHold&) = delete;
  LaneHold& operator=(const LaneHold&) = delete;
  ~LaneHold() {
    {
      const std::lock_guard lock(process_.lane_mutex_);
      process_.free_lanes_.push_back(index_);
    }
    process_.lane_freed_.notify_one();
  }

  std::size_t index() const { return index_; }

 private:
  BrushProcess& process_;
  std::size_t index_;
};

void BrushProcess::run(const BatchCall& call, std::size_t first, std::size_t count) {
  const LaneHold hold(*this);
  if (failed_) fail({}, 0);
  std::byte* memory = lane(hold.index());
  auto& shared = *reinterpret_cast<LaneCall*>(memory);
  const PackedOutputs packed = pack(call, first, count, memory);
  pass_turn(shared.turn, Turn::asked);
  wait_for_turn(shared, hold.index());
  drain_log();
  const burin_status status = shared.status;
  if (status != BURIN_OK) throw plugin::Error(text_of(shared.text), status);
  unpack(packed, memory, call, first, count);
}

void BrushProcess::wait_for_turn(LaneCall& lane, std::size_t index) {
  const Clock::time_point deadline = deadline_in(isolation_.batch_seconds);
  while (lane.turn.load() != Turn::answered) {
    wait_on(lane.turn, Turn::asked, look);
    if (lane.turn.load() == Turn::answered) return;
    if (failed_ || !process_->running() || header().crash.told.load() != 0) fail({}, 0);
    if (Clock::now() >= deadline)
      fail(isolation_.batch_seconds, index < lane_threads_.size() ? lane_threads_[index] : 0);
  }
}

void BrushProcess::fail(std::optional<double> late_after, pid_t thread) {
  const std::lock_guard lock(failure_mutex_);
  if (failure_.empty()) {
    failure_ = reason(late_after, thread);
    failed_ = true;
    drain_log();
  }
  throw Error(failure_);
}

/// Why the process has failed, which is gone then. `late_after`: the seconds that it was given, if it took
/// longer in this thread.
std::string BrushProcess::reason(std::optional<double> late_after, pid_t thread) {
  const CrashRecord& record = header().crash;
  if (late_after) process_->interrupt(thread, SIGUSR2);
  const Clock::time_point deadline = deadline_in(time_to_tell);
  while (process_->running() && record.told.load() < 2 && Clock::now() < deadline)
    process_->wait(Clock::now() + std::chrono::milliseconds(1));
  const bool running = process_->running();
  const std::string ending = process_->end();
  const bool told = record.told.load() != 0;
  if (late_after) return fmt::format("took more than {:g} s{}", *late_after, told ? where(record) : "");
  if (told) return crash_text(record);
  if (running) return "its process gave an answer that is none";
  if (ending == fmt::format("exited with status {}", wrong_version))
    return "its process belongs to another version of Burin than " BURIN_VERSION;
  return "its process " + ending;
}

std::string BrushProcess::failure() const {
  const std::lock_guard lock(failure_mutex_);
  return failure_;
}

/// Passes on what the process has logged.
void BrushProcess::drain_log() {
  const std::uint32_t logged = header().logged.load(std::memory_order_relaxed);
  if (logged == lines_logged_.load(std::memory_order_relaxed)) return;
  const std::lock_guard lock(log_mutex_);
  lines_logged_ = logged;
  // A bound, lest a brush that does nothing but log keeps the host.
  for (int i = 0; i < 1000; ++i) {
    std::array<std::byte, 4096> line{};
    const ssize_t size = recv(log_socket_.number(), line.data(), line.size(), MSG_DONTWAIT);
    if (size < static_cast<ssize_t>(sizeof(std::int32_t))) return;
    std::int32_t severity = 0;
    std::memcpy(&severity, line.data(), sizeof severity);
    const std::string_view text(reinterpret_cast<const char*>(line.data()) + sizeof severity,
                                static_cast<std::size_t>(size) - sizeof severity);
    if (log_) log_(severity, shown_text(text, line.size()));
  }
}

}  // namespace burin::isolate
#endif
