#pragma once
#include <burin/host/plugin/services.h>
#include <burin/services/stamp_services.h>
#include <burin/services/stamp_store.h>
#include <burin/volume/voxel_field.h>

#include <array>
#include <filesystem>
#include <memory>
#include <utility>

namespace burin {

/// A grid of a .vdb file, and the axes along which it repeats.
struct VdbStamp {
  std::shared_ptr<const VoxelField> field;
  std::array<bool, 3> periodic{};
};

/// What a .vdb stamp is opened with; the path is canonical.
struct VdbStampKey {
  std::filesystem::path path;
  VoxelFieldOptions options;
  std::array<bool, 3> periodic{};

  bool operator==(const VdbStampKey&) const = default;
};

/// The services that stamp_services() returns, and the stamps that are open through them.
class StampExtensions : public HostExtensions {
 public:
  using VdbStamps = HandleStore<VdbStampKey, VdbStamp>;

  /// `reader` may be null: then there are no .vdb stamps.
  explicit StampExtensions(VdbReader reader) : read_vdb_(reader) {}

  const void* find(std::string_view id) const override;
  StampStore& stamps() { return stamps_; }
  VdbStamps& vdb_stamps() { return vdb_stamps_; }
  VdbReader read_vdb() const { return read_vdb_; }

 private:
  VdbReader read_vdb_;
  StampStore stamps_;
  VdbStamps vdb_stamps_{".vdb stamps"};
};

}  // namespace burin
