// Implements the host's service burin.vdb-stamps/1: checks arguments at the ABI, and samples open grids.
#include <burin/host/plugin/utf8_path.h>
#include <burin/services/service_tables.h>

#include <cmath>
#include <system_error>

namespace burin {
namespace {

StampExtensions::VdbStamps& vdb_stamps_of(const burin_host* host) { return extensions_of(host).vdb_stamps(); }

burin_vdb_info info_of(const VoxelField& field) {
  const auto along = [&](int axis) { return static_cast<std::uint32_t>(field.size()[axis]); };
  return {.struct_size = 0,
          .kind = field.kind() == VoxelField::Kind::level_set ? BURIN_VDB_LEVEL_SET : BURIN_VDB_FOG,
          .size = {along(0), along(1), along(2)},
          .minimum = field.minimum(),
          .maximum = field.maximum(),
          .reserved = 0};
}

burin_status BURIN_CALL open(const burin_host* host, const char* path, const burin_vdb_options* options,
                             burin_vdb_stamp* stamp, burin_vdb_info* info, burin_text* error) {
  if (!path || !options || !stamp) return BURIN_INVALID_ARGUMENT;
  const burin_vdb_options known = known_members(*options);
  if (!std::isfinite(known.surface_at) || known.surface_at < 0) return BURIN_INVALID_ARGUMENT;
  return status_of(error, [&] {
    const std::filesystem::path file = path_from_utf8(path);
    std::error_code unknown;  // ignored, since the reader reports what is wrong with the path
    const VdbStampKey key{
        std::filesystem::weakly_canonical(file, unknown),
        {known.grid ? known.grid : "", known.surface_at},
        {(known.periodic & BURIN_VDB_PERIODIC_X) != 0, (known.periodic & BURIN_VDB_PERIODIC_Y) != 0,
         (known.periodic & BURIN_VDB_PERIODIC_Z) != 0}};
    stamp->handle = vdb_stamps_of(host).open(key, [&] {
      return VdbStamp{extensions_of(host).read_vdb()(file, key.options), key.periodic};
    });
    fill_known_members(info_of(*vdb_stamps_of(host).find(stamp->handle)->field), info);
  });
}

void BURIN_CALL close(const burin_host* host, burin_vdb_stamp stamp) {
  vdb_stamps_of(host).close(stamp.handle);
}

double coordinate(const burin_floats& floats, std::size_t i) {
  return static_cast<double>(floats.data[i * floats.stride]);
}

burin_status BURIN_CALL sample(const burin_host* host, burin_vdb_stamp stamp, std::uint32_t count,
                               burin_floats voxel, burin_floats x, burin_floats y, burin_floats z,
                               burin_floats_out values) {
  const VdbStamp* opened = vdb_stamps_of(host).find(stamp.handle);
  if (!opened) return BURIN_NOT_FOUND;
  const bool distances = opened->field->kind() == VoxelField::Kind::level_set;
  for (std::size_t i = 0; i < count; ++i) {
    const double edge = coordinate(voxel, i);
    if (!(edge > 0)) return BURIN_INVALID_ARGUMENT;
    const float value = opened->field->at(Vec3d(coordinate(x, i), coordinate(y, i), coordinate(z, i)) / edge,
                                          opened->periodic);
    if (!std::isfinite(value)) return BURIN_INVALID_ARGUMENT;
    values.data[i * values.stride] = distances ? value * static_cast<float>(edge) : value;
  }
  return BURIN_OK;
}

}  // namespace

constexpr burin_vdb_stamps vdb_stamps_service{sizeof(burin_vdb_stamps), 0, open, close, sample};

}  // namespace burin
