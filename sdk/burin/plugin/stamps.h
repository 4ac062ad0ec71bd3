#pragma once
#include <burin/abi/ext/stamps.h>
#include <burin/abi/ext/vdb_stamps.h>
#include <burin/plugin/detail/error.h>
#include <burin/plugin/detail/host.h>
#include <burin/plugin/detail/views.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace burin::plugin {

/// A position in a stamp: (0, 0) upper left, (1, 1) lower right. The wrap defines the values outside.
struct StampPoint {
  float u, v;
};

/// The area of a stamp that a node's cell covers: the ellipse inscribed in the parallelogram that is centred
/// at `at` and has the sides `along` and `across`. These are the cell's sides, footprint_t along e1 and
/// footprint_d along e2, in u and v.
struct StampArea {
  StampPoint at;
  StampPoint along, across;
};

/// Options for opening an image.
struct StampOptions {
  burin_stamp_wrap wrap_u = BURIN_WRAP_UNKNOWN;  ///< unknown: the mode stored in the file, else periodic
  burin_stamp_wrap wrap_v = BURIN_WRAP_UNKNOWN;
  bool clean = false;  ///< fill texels that are not finite from their neighbours instead of refusing the file
  const char* layer = "";    ///< layer of a file with several; empty: chosen by its name
  const char* channel = "";  ///< one name, or three or four separated by commas; empty: chosen by their names
  float zero = 0;            ///< the file's value that becomes 0; does not apply to alpha
};

namespace detail {

/// Calls `open(burin_text*)`. Throws Error with the host's text, or `otherwise`, unless it returns BURIN_OK.
template <class Open>
void open_or_throw(const char* otherwise, const Open& open) {
  std::array<char, 512> line{};
  burin_text text{sizeof text, static_cast<std::uint32_t>(line.size()), line.data()};
  const burin_status status = open(&text);
  if (status != BURIN_OK) throw Error(line[0] ? line.data() : otherwise, status);
}

}  // namespace detail

/// An image file that the host keeps open during the object's lifetime. Usually a member of a brush, opened
/// by the brush's constructor. Sampling may run on any thread, concurrently.
class Stamp {
 public:
  /// Throws Error if the host has no stamps or cannot open the file; the text is the host's.
  Stamp(const Host& host, const char* path, const StampOptions& options = {})
      : Stamp(host,
              [&](const burin_stamps& stamps, burin_stamp* stamp, burin_stamp_info* info, burin_text* error) {
                const burin_stamp_options raw{sizeof raw,    options.wrap_u,  options.wrap_v, options.clean,
                                              options.layer, options.channel, options.zero,   0};
                return stamps.open_with(host.raw(), path, &raw, stamp, info, error);
              }) {}

  /// Opens a stamp by calling `open(burin_stamps, burin_stamp*, burin_stamp_info*, burin_text*)`.
  template <class Open>
  Stamp(const Host& host, const Open& open) : host_(host.raw()) {
    const auto* stamps = host.service<burin_stamps>(BURIN_EXT_STAMPS);
    if (!stamps || !BURIN_HAS(stamps, burin_stamps, sample_area))
      throw Error("this host cannot sample stamps", BURIN_UNSUPPORTED);
    service_ = complete(*stamps);
    info_.struct_size = sizeof info_;
    detail::open_or_throw("the stamp cannot be opened",
                          [&](burin_text* text) { return open(service_, &stamp_, &info_, text); });
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

  /// Size in texels, number of channels, range of the first channel, wrap.
  const burin_stamp_info& info() const { return info_; }

  /// Height over width.
  float aspect() const { return static_cast<float>(info_.height) / static_cast<float>(info_.width); }

  /// Writes the means of a channel over the areas area(0) .. area(count - 1), each a StampArea, into
  /// `values`. Throws Error if the host cannot sample, as for an area that is not finite.
  template <class Area>
  void sample(std::size_t count, const Area& area, const FloatsOut& values, std::uint32_t channel = 0) const {
    Block block;
    for (std::size_t first = 0; first < count; first += Block::capacity) {
      const std::size_t size = std::min(Block::capacity, count - first);
      for (std::size_t i = 0; i < size; ++i) block.set(i, area(first + i));
      const burin_stamp_area areas = block.areas();
      const burin_status status =
          service_.sample_area(host_, stamp_, channel, static_cast<std::uint32_t>(size), block.column(0),
                               block.column(1), &areas, values.from(first).raw());
      if (status != BURIN_OK) throw Error("the host refused to sample a stamp", status);
    }
  }

 private:
  /// The areas of one call of the host, on the stack.
  class Block {
   public:
    static constexpr std::size_t capacity = 256;

    void set(std::size_t i, const StampArea& area) {
      const float numbers[] = {area.at.u,    area.at.v,     area.along.u,
                               area.along.v, area.across.u, area.across.v};
      for (std::size_t k = 0; k < columns_.size(); ++k) columns_[k][i] = numbers[k];
    }
    burin_floats column(std::size_t k) const { return {columns_[k].data(), 1, 0}; }
    burin_stamp_area areas() const { return {column(2), column(3), column(4), column(5)}; }

   private:
    std::array<std::array<float, capacity>, 6> columns_;
  };

  const burin_host* host_;
  burin_stamps service_{};
  burin_stamp stamp_{};
  burin_stamp_info info_{};
};

/// A place in a .vdb stamp, from the least corner of its box, where a voxel is `voxel` long; lengths in one
/// unit.
struct VdbPoint {
  float x, y, z, voxel;
};

/// Options for opening a grid of a .vdb file.
struct VdbOptions {
  std::uint32_t periodic = BURIN_VDB_PERIODIC_X;  ///< BURIN_VDB_PERIODIC_*: where the box repeats
  const char* grid = "";                          ///< its name; empty: the first grid of floats
  double surface_at = 0;  ///< above 0: a fog volume is opened as the level set of this density
};

/// A grid of a .vdb file, as burin/abi/ext/vdb_stamps.h describes it, that the host keeps open during the
/// object's lifetime. Sampling may run on any thread, concurrently.
class VdbStamp {
 public:
  /// Throws Error if the host has no .vdb stamps or cannot open the file; the text is the host's.
  VdbStamp(const Host& host, const char* path, const VdbOptions& options = {}) : host_(host.raw()) {
    const auto* stamps = host.service<burin_vdb_stamps>(BURIN_EXT_VDB_STAMPS);
    if (!stamps || !BURIN_HAS(stamps, burin_vdb_stamps, sample))
      throw Error("this host cannot sample .vdb files", BURIN_UNSUPPORTED);
    service_ = complete(*stamps);
    info_.struct_size = sizeof info_;
    const burin_vdb_options raw{sizeof raw, options.periodic, options.grid, options.surface_at};
    detail::open_or_throw("the .vdb file cannot be opened", [&](burin_text* text) {
      return service_.open(host_, path, &raw, &stamp_, &info_, text);
    });
  }
  VdbStamp(const VdbStamp&) = delete;
  VdbStamp& operator=(const VdbStamp&) = delete;
  ~VdbStamp() { service_.close(host_, stamp_); }

  /// Kind, size of the box in voxels, range of the values.
  const burin_vdb_info& info() const { return info_; }

  /// Writes the values at place(0) .. place(count - 1), each a VdbPoint: distances in the places' unit, or
  /// densities. Throws Error if the host cannot sample, as for a place that is not finite.
  template <class PlaceAt>
  void sample(std::size_t count, const PlaceAt& place, const FloatsOut& values) const {
    constexpr std::size_t capacity = 256;
    std::array<std::array<float, capacity>, 4> columns;
    const auto column = [&](std::size_t k) { return burin_floats{columns[k].data(), 1, 0}; };
    for (std::size_t first = 0; first < count; first += capacity) {
      const std::size_t size = std::min(capacity, count - first);
      for (std::size_t i = 0; i < size; ++i) {
        const VdbPoint at = place(first + i);
        columns[0][i] = at.voxel;
        columns[1][i] = at.x;
        columns[2][i] = at.y;
        columns[3][i] = at.z;
      }
      const burin_status status = service_.sample(host_, stamp_, static_cast<std::uint32_t>(size), column(0),
                                                  column(1), column(2), column(3), values.from(first).raw());
      if (status != BURIN_OK) throw Error("the host refused to sample a .vdb stamp", status);
    }
  }

 private:
  const burin_host* host_;
  burin_vdb_stamps service_{};
  burin_vdb_stamp stamp_{};
  burin_vdb_info info_{};
};

}  // namespace burin::plugin
