#pragma once
#include <burin/abi/host.h>
#include <burin/host/stamp_store.h>

#include <string_view>

namespace burin {

/// What this host gives to plugins: the log, stamps and lettering. Must stay in place while plugins know of
/// it.
class HostServices {
 public:
  /// Must not throw. Any thread, concurrent.
  using Log = void (*)(int severity, std::string_view line);

  explicit HostServices(Log log);
  HostServices(const HostServices&) = delete;
  HostServices& operator=(const HostServices&) = delete;

  const burin_host* abi() const { return &host_; }
  StampStore& stamps() { return stamps_; }

  /// Hands a line to the log, if there is one.
  void write_log(int severity, std::string_view line) const;

 private:
  Log log_;
  StampStore stamps_;
  burin_host host_;
};

}  // namespace burin
