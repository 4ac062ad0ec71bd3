// Finds the services of this folder by their ids.
#include <burin/services/service_tables.h>
#include <burin/services/stamp_services.h>

namespace burin {

const void* StampExtensions::find(std::string_view id) const {
  if (id == BURIN_EXT_STAMPS) return &stamps_service;
  if (id == BURIN_EXT_LETTERING) return &lettering_service;
  if (id == BURIN_EXT_VDB_STAMPS && read_vdb_) return &vdb_stamps_service;
  return nullptr;
}

std::unique_ptr<HostExtensions> stamp_services(VdbReader read_vdb) {
  return std::make_unique<StampExtensions>(read_vdb);
}

}  // namespace burin
