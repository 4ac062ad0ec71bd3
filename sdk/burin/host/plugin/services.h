#pragma once
#include <burin/abi/host.h>
#include <burin/host/host_extensions.h>

#include <memory>
#include <string_view>

namespace burin {

/// What this host gives to plugins: the log, and the extensions of the application. Must stay in place while
/// plugins know of it.
class HostServices {
 public:
  /// Must not throw. Any thread, concurrent.
  using Log = void (*)(int severity, std::string_view line);

  /// `extensions`: null for none.
  explicit HostServices(Log log, std::unique_ptr<HostExtensions> extensions = nullptr);
  HostServices(const HostServices&) = delete;
  HostServices& operator=(const HostServices&) = delete;

  const burin_host* abi() const { return &host_; }
  HostExtensions* extensions() const { return extensions_.get(); }

  /// Hands a line to the log, if there is one.
  void write_log(int severity, std::string_view line) const;

 private:
  Log log_;
  std::unique_ptr<HostExtensions> extensions_;
  burin_host host_;
};

/// The services behind what a plugin was given.
inline HostServices& services(const burin_host* host) { return *static_cast<HostServices*>(host->self); }

}  // namespace burin
