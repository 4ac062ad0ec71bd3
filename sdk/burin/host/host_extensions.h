#pragma once
#include <string_view>

namespace burin {

/// What an application gives to plugins besides the log: interfaces of burin/abi/ext by their id. Any thread,
/// concurrent. burin/services/stamp_services.h has those of Burin itself.
class HostExtensions {
 public:
  virtual ~HostExtensions() = default;

  /// The interface of this id, valid as long as the object; null where there is none. Must not throw.
  virtual const void* find(std::string_view id) const = 0;
};

}  // namespace burin
