#pragma once
#include <burin/abi/ext/stamps.h>
#include <burin/plugin/error.h>
#include <burin/plugin/host.h>
#include <burin/plugin/views.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace burin::plugin {

/// A place in a stamp: (0, 0) upper left, (1, 1) lower right, repeating with period 1.
struct StampPlace {
  float u, v;
};

/// An image file, open through the host while the object lives: a member of a brush, opened by the brush's
/// constructor. Sampling is for any thread, concurrently.
class Stamp {
 public:
  /// Throws Error: the host has no stamps, or it cannot open the file (with the host's words).
  Stamp(const Host& host, const char* path) : host_(host.raw()) {
    const auto* stamps = host.service<burin_stamps>(BURIN_EXT_STAMPS);
    if (!stamps || !BURIN_HAS(stamps, burin_stamps, sample))
      throw Error("this host cannot sample stamps", BURIN_UNSUPPORTED);
    service_ = complete(*stamps);
    std::array<char, 512> line{};
    burin_text text{sizeof text, static_cast<std::uint32_t>(line.size()), line.data()};
    info_.struct_size = sizeof info_;
    const burin_status status = service_.open(host_, path, &stamp_, &info_, &text);
    if (status != BURIN_OK)
      throw Error(line[0] ? line.data() : std::string(path) + ": cannot be opened", status);
  }
  Stamp(Stamp&& other) noexcept
      : host_(other.host_),
        service_(other.service_),
        stamp_(std::exchange(other.stamp_, burin_stamp{})),
        info_(other.info_) {}
  Stamp& operator=(Stamp&&) = delete;
  ~Stamp() {
    if (stamp_.handle) service_.close(host_, stamp_);
  }

  /// Size in texels, channels, range of the first channel.
  const burin_stamp_info& info() const { return info_; }

  /// Writes into `values` the bilinear samples at place(0) .. place(count - 1), each a StampPlace.
  /// Throws Error when the host refuses.
  template <class Place>
  void sample(std::size_t count, const Place& place, const FloatsOut& values,
              std::uint32_t channel = 0) const {
    constexpr std::size_t block = 256;  // keeps the places on the stack
    std::array<float, block> u, v;
    for (std::size_t first = 0; first < count; first += block) {
      const std::size_t size = std::min(block, count - first);
      for (std::size_t i = 0; i < size; ++i) {
        const StampPlace at = place(first + i);
        u[i] = at.u;
        v[i] = at.v;
      }
      const auto n = static_cast<std::uint32_t>(size);
      const burin_status status = service_.sample(host_, stamp_, channel, n, {u.data(), 1, 0},
                                                  {v.data(), 1, 0}, values.from(first).raw());
      if (status != BURIN_OK) throw Error("the host refused to sample a stamp", status);
    }
  }

 private:
  const burin_host* host_;
  burin_stamps service_{};
  burin_stamp stamp_{};
  burin_stamp_info info_{};
};

}  // namespace burin::plugin
