#pragma once
#include <string_view>

namespace burin {

/// The extension interfaces (burin/abi/ext) that an application provides to plugins besides the log. Called
/// on any thread, also on several at once. burin/services/stamp_services.h implements those of Burin itself.
class HostExtensions {
 public:
  virtual ~HostExtensions() = default;

  /// Returns the interface with this id, which is valid as long as the object, or null. Must not throw.
  virtual const void* find(std::string_view id) const = 0;
};

}  // namespace burin
