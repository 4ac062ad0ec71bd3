#pragma once
#include <burin/host/isolate/message.h>

#include <chrono>
#include <functional>

namespace burin::isolate {

/// What the host asks of a brush's process. Each request has one answer.
enum class Request : std::uint32_t {
  describe = 1,  ///< load a module, tell its descriptors, unload it
  create,        ///< load a module and create one brush of it
  save_state,
  load_state,
  begin,
  end,
  curve_reach,
  curve_filter,
  solid_plan,
  quit,  ///< destroy the brush, unload its module and end
};

/// The status with which the program exits if it belongs to another version of Burin than the host.
inline constexpr int wrong_version = 64;

/// A file descriptor that is closed by the destructor.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(other.number_) { other.number_ = -1; }
  Descriptor& operator=(Descriptor&& other) noexcept;
  ~Descriptor();

  int number() const { return number_; }

 private:
  int number_;
};

using Clock = std::chrono::steady_clock;

/// The end of a time from now; the greatest time point for infinity.
Clock::time_point deadline_in(double seconds);

/// Milliseconds until then for poll(), rounded up; at most 1000.
int poll_time(Clock::time_point deadline);

/// The greatest message, bytes; above the greatest state of a brush that a session carries over.
inline constexpr std::uint64_t most_message = (std::uint64_t{1} << 30) + (std::uint64_t{1} << 20);

/// Sends a message through a stream socket: its size, then its bytes. Returns false if the other side is gone
/// or if `wait` says so: it is called before every part, and waits until the socket takes more.
bool send_message(int socket, std::span<const std::byte> bytes, const std::function<bool()>& wait);

/// Receives one, likewise; `wait` waits until there is more. Returns false also if it is too large.
bool receive_message(int socket, Bytes& bytes, const std::function<bool()>& wait);

}  // namespace burin::isolate
