// Passes Burin's services on, and notes which of them the plugin asks for.
#include "validate/probe/probe_host.h"

#include <burin/level_set/solid_mesh.h>
#include <burin/services/stamp_services.h>

#include <mutex>

namespace burin::validate {
namespace {

// The services of burin_host.self are Burin's own, so the probe itself is found here.
ProbeHost* current = nullptr;
std::mutex asking;

}  // namespace

ProbeHost::ProbeHost() : services_(nullptr, stamp_services(read_vdb)), host_(*services_.abi()) {
  host_.get_extension = get_extension;
  current = this;
}

ProbeHost::~ProbeHost() { current = nullptr; }

const void* BURIN_CALL ProbeHost::get_extension(const burin_host* host, const char* id) {
  if (!id || !current) return nullptr;
  const std::lock_guard guard(asking);
  current->asked.insert(id);
  if (current->withheld.contains(id)) return nullptr;
  return services(host).abi()->get_extension(host, id);
}

}  // namespace burin::validate
