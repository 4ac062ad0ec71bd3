// Fills the ABI's table of host services, and finds extensions by their ids.
#include <burin/abi/ext/log.h>
#include <burin/host/plugin/services.h>
#include <burin/version.h>

#include <cstring>
#include <utility>

namespace burin {
namespace {

void BURIN_CALL write_log_line(const burin_host* host, burin_log_severity severity, const char* line) {
  if (line) services(host).write_log(severity, line);
}

constexpr burin_log log_service{sizeof(burin_log), 0, write_log_line};

const void* BURIN_CALL get_extension(const burin_host* host, const char* id) {
  if (!id) return nullptr;
  if (std::strcmp(id, BURIN_EXT_LOG) == 0) return &log_service;
  const HostExtensions* extensions = services(host).extensions();
  return extensions ? extensions->find(id) : nullptr;
}

}  // namespace

HostServices::HostServices(Log log, std::unique_ptr<HostExtensions> extensions)
    : log_(std::move(log)),
      extensions_(std::move(extensions)),
      host_{.struct_size = sizeof(burin_host),
            .abi_major = BURIN_ABI_MAJOR,
            .abi_minor = BURIN_ABI_MINOR,
            .reserved = 0,
            .self = this,
            .name = "Burin",
            .version = BURIN_VERSION,
            .get_extension = get_extension} {}

void HostServices::write_log(int severity, std::string_view line) const {
  if (log_) log_(severity, line);
}

}  // namespace burin
