// Implements the entry point of the module burin-solids.so.
#include <burin/level_set/solid_mesh.h>
#include <burin/solid_module/solid_module.h>
#include <burin/version.h>

#include <string_view>

const burin::SolidTools* burin_solid_tools(const char* version) {
  static constexpr burin::SolidTools tools{burin::merge_solid, burin::mesh_of, burin::read_vdb};
  return std::string_view(version) == BURIN_VERSION ? &tools : nullptr;
}
