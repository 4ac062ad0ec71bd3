#pragma once
#include <burin/abi/host.h>
#include <burin/host/plugin/services.h>

#include <set>
#include <string>

namespace burin::validate {

/// A host with Burin's services. One at a time.
class ProbeHost {
 public:
  ProbeHost();
  ProbeHost(const ProbeHost&) = delete;
  ProbeHost& operator=(const ProbeHost&) = delete;
  ~ProbeHost();

  const burin_host* abi() const { return &host_; }

  std::set<std::string> withheld;  ///< ids of services that the host does not have
  std::set<std::string> asked;     ///< ids that the plugin asked for

 private:
  static const void* BURIN_CALL get_extension(const burin_host* host, const char* id);

  HostServices services_;
  burin_host host_;
};

}  // namespace burin::validate
