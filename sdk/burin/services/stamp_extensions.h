#pragma once
#include <burin/host/plugin/services.h>
#include <burin/services/stamp_store.h>

namespace burin {

/// The services that stamp_services() returns, and the stamps that are open through them.
class StampExtensions : public HostExtensions {
 public:
  const void* find(std::string_view id) const override;
  StampStore& stamps() { return stamps_; }

 private:
  StampStore stamps_;
};

}  // namespace burin
