// The process's side of host/isolate/brush_process.cpp, which describes what is shared and in which order.
#include "server.h"

#include <burin/base/error.h>
#include <burin/host/isolate/channel.h>
#include <burin/host/isolate/descriptor_message.h>
#include <burin/host/isolate/shared_memory.h>
#include <burin/host/plugin/plugin_module.h>
#include <burin/host/plugin/services.h>
#include <burin/plugin/detail/error.h>
#include <fcntl.h>
#include <malloc.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fstream>
#include <new>
#include <optional>
#include <utility>

#include "crash_handler.h"
#include "lane_threads.h"
#include "served_brush.h"

namespace burin::process {
namespace {

using isolate::Bytes;
using isolate::MessageReader;
using isolate::MessageWriter;
using isolate::Request;
using isolate::SharedHeader;

/// Ends the process when the host does, whatever the brush is busy with: the kernel kills it as soon as the
/// pipe has no writer.
void end_with_host() {
  fcntl(isolate::life_descriptor, F_SETOWN, getpid());
  fcntl(isolate::life_descriptor, F_SETSIG, SIGKILL);
  fcntl(isolate::life_descriptor, F_SETFL, O_ASYNC | O_NONBLOCK);
  char nothing = 0;
  // The host may have ended before.
  if (read(isolate::life_descriptor, &nothing, 1) == 0) _exit(1);
}

std::byte* map_memory() {
  const off_t size = lseek(isolate::memory_descriptor, 0, SEEK_END);
  void* memory = mmap(nullptr, static_cast<std::size_t>(size), PROT_READ | PROT_WRITE, MAP_SHARED,
                      isolate::memory_descriptor, 0);
  if (memory == MAP_FAILED) _exit(1);
  return static_cast<std::byte*>(memory);
}

/// The address space in use, bytes.
std::uint64_t address_space() {
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

/// Bounds what the brush may take, beyond what the process has and what stacks and heaps of threads reserve.
/// Where the machine has no memory left, the system ends this process rather than the host. A crash leaves no
/// file.
void bound_resources(const SharedHeader& header) {
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
  std::ofstream("/proc/self/oom_score_adj") << 1000;
  if (header.memory == 0) return;
  constexpr int heaps = 2;
  mallopt(M_ARENA_MAX, heaps);
  constexpr std::uint64_t mega = 1 << 20, of_heaps = heaps * 64 * mega, of_stack = 9 * mega;
  const std::uint64_t bytes = address_space() + of_heaps + header.lanes * of_stack + header.memory;
  const rlimit limit{bytes, bytes};
  setrlimit(RLIMIT_AS, &limit);
}

/// What is shared with nobody whom the brush starts.
void close_on_exec() {
  for (int number = isolate::socket_descriptor; number <= isolate::log_descriptor; ++number)
    fcntl(number, F_SETFD, FD_CLOEXEC);
}

bool wait_for(short events) {
  pollfd watched{isolate::socket_descriptor, events, 0};
  poll(&watched, 1, -1);
  return true;
}

/// Sends lines of the log to the host; those that it has no room for are lost.
HostServices::Log log_to_host(SharedHeader& header) {
  return [&header](int severity, std::string_view line) {
    std::array<char, 4000> message{};
    const std::int32_t number = severity;
    std::memcpy(message.data(), &number, sizeof number);
    const std::size_t size = std::min(line.size(), message.size() - sizeof number);
    std::memcpy(message.data() + sizeof number, line.data(), size);
    if (send(isolate::log_descriptor, message.data(), sizeof number + size, MSG_DONTWAIT | MSG_NOSIGNAL) > 0)
      ++header.logged;
  };
}

/// What answers requests.
class Server {
 public:
  Server(std::byte* memory, std::unique_ptr<HostExtensions> extensions)
      : memory_(memory),
        services_(log_to_host(*reinterpret_cast<SharedHeader*>(memory)), std::move(extensions)) {}

  /// Answers requests until the host asks for the end or is gone.
  void run() {
    Bytes request;
    while (isolate::receive_message(isolate::socket_descriptor, request, [] { return wait_for(POLLIN); })) {
      MessageReader reader{request};
      const auto what = reader.value<Request>();
      if (what == Request::quit) return quit();
      send(answer(what, MessageReader(reader.block())));
    }
  }

 private:
  void send(const Reply& reply) {
    MessageWriter message;
    message.value(reply.status).text(reply.text);
    Bytes bytes = message.bytes();
    bytes.insert(bytes.end(), reply.content.bytes().begin(), reply.content.bytes().end());
    isolate::send_message(isolate::socket_descriptor, bytes, [] { return wait_for(POLLOUT); });
  }

  Reply answer(Request what, MessageReader from) {
    try {
      if (what == Request::describe) return describe(from.text());
      if (what == Request::create) return create(from);
      if (!brush_) throw Error("no brush was created");
      return brush_->answer(what, from);
    } catch (const std::bad_alloc&) {
      return {BURIN_OUT_OF_MEMORY, "out of memory", {}};
    } catch (const std::exception& error) {
      return {BURIN_ERROR, error.what(), {}};
    }
  }

  static Reply describe(const std::string& path) {
    tell_functions_of(path);
    const PluginModule module(path, path);
    MessageWriter descriptors;
    isolate::write_descriptors(descriptors, module.brushes());
    Reply reply;
    reply.content.block(descriptors.bytes());
    return reply;
  }

  Reply create(MessageReader& from) {
    const std::string path = from.text(), id = from.text();
    tell_functions_of(path);
    brush_.emplace(path, id, *services_.abi());
    const std::vector<pid_t> threads = start_lane_threads(memory_, *brush_);
    MessageWriter descriptors;
    isolate::write_descriptors(descriptors, brush_->module().brushes());
    Reply reply{BURIN_OK, {}, brush_->offer()};
    reply.content.block(std::as_bytes(std::span(threads))).block(descriptors.bytes());
    return reply;
  }

  /// Nothing of the library's own runs any more, since the threads of the lanes do.
  void quit() {
    brush_.reset();
    expect_exit();
    send({});
    std::fflush(nullptr);
    _exit(0);
  }

  std::byte* memory_;
  HostServices services_;
  std::optional<ServedBrush> brush_;
};

}  // namespace

int serve(std::unique_ptr<HostExtensions> extensions) {
  close_on_exec();
  end_with_host();
  std::byte* memory = map_memory();
  auto& header = *reinterpret_cast<SharedHeader*>(memory);
  tell_crashes(header.crash);
  bound_resources(header);
  Server(memory, std::move(extensions)).run();
  expect_exit();
  return 0;
}

}  // namespace burin::process
