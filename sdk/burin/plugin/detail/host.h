#pragma once
#include <burin/abi/host.h>
#include <burin/plugin/detail/complete.h>

namespace burin::plugin {

/// The application that runs the brush. Any thread; it outlives every stroke.
class Host {
 public:
  explicit Host(const burin_host* host) : host_(host) {}

  const burin_host* raw() const { return host_; }

  /// The host's service with this id, or null if the host does not have it. `Service` is the struct that the
  /// header of the id in burin/abi/ext declares.
  template <class Service>
  const Service* service(const char* id) const {
    const auto get_extension = complete(*host_).get_extension;
    return get_extension ? static_cast<const Service*>(get_extension(host_, id)) : nullptr;
  }

 private:
  const burin_host* host_;
};

}  // namespace burin::plugin
