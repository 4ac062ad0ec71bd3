// Messages on a non-blocking stream socket. Memory for a message grows with what has really come.
#if defined(__linux__)
#include <burin/host/isolate/channel.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <utility>

namespace burin::isolate {
namespace {

bool is_temporary(int error) { return error == EAGAIN || error == EWOULDBLOCK || error == EINTR; }

bool send_bytes(int socket, std::span<const std::byte> bytes, const std::function<bool()>& wait) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent >= 0)
      bytes = bytes.subspan(static_cast<std::size_t>(sent));
    else if (!is_temporary(errno) || !wait())
      return false;
  }
  return true;
}

bool receive_bytes(int socket, std::span<std::byte> bytes, const std::function<bool()>& wait) {
  while (!bytes.empty()) {
    const ssize_t received = ::recv(socket, bytes.data(), bytes.size(), MSG_DONTWAIT);
    if (received > 0)
      bytes = bytes.subspan(static_cast<std::size_t>(received));
    else if (received == 0 || !is_temporary(errno) || !wait())
      return false;
  }
  return true;
}

}  // namespace

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  std::swap(number_, other.number_);
  return *this;
}

Descriptor::~Descriptor() {
  if (number_ >= 0) close(number_);
}

Clock::time_point deadline_in(double seconds) {
  constexpr double longest = 1e9;
  if (!(seconds < longest)) return Clock::time_point::max();
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

int poll_time(Clock::time_point deadline) {
  const Clock::time_point now = Clock::now();
  if (deadline <= now) return 0;
  const double left = std::chrono::duration<double>(deadline - now).count();
  return static_cast<int>(std::ceil(1000 * std::min(left, 1.0)));
}

bool send_message(int socket, std::span<const std::byte> bytes, const std::function<bool()>& wait) {
  const std::uint64_t size = bytes.size();
  return send_bytes(socket, std::as_bytes(std::span(&size, 1)), wait) && send_bytes(socket, bytes, wait);
}

bool receive_message(int socket, Bytes& bytes, const std::function<bool()>& wait) {
  std::uint64_t size = 0;
  if (!receive_bytes(socket, std::as_writable_bytes(std::span(&size, 1)), wait)) return false;
  if (size > most_message) return false;
  constexpr std::size_t part = std::size_t{1} << 20;
  bytes.clear();
  while (bytes.size() < size) {
    const std::size_t before = bytes.size();
    bytes.resize(std::min<std::size_t>(before + part, static_cast<std::size_t>(size)));
    if (!receive_bytes(socket, std::span(bytes).subspan(before), wait)) return false;
  }
  return true;
}

}  // namespace burin::isolate
#endif
