#pragma once
#include <burin/abi/host.h>
#include <burin/host/host_extensions.h>

#include <functional>
#include <memory>
#include <string_view>

namespace burin {

/// The services of this host for plugins: the log, and the extensions of the application. The object must
/// stay in place while plugins refer to it.
class HostServices {
 public:
  /// Must not throw. Called on any thread, also on several at once.
  using Log = std::function<void(int severity, std::string_view line)>;

  /// `log` and `extensions` may be empty.
  explicit HostServices(Log log, std::unique_ptr<HostExtensions> extensions = nullptr);
  HostServices(const HostServices&) = delete;
  HostServices& operator=(const HostServices&) = delete;

  const burin_host* abi() const { return &host_; }
  HostExtensions* extensions() const { return extensions_.get(); }

  /// Passes a line to the log, if there is one.
  void write_log(int severity, std::string_view line) const;

 private:
  Log log_;
  std::unique_ptr<HostExtensions> extensions_;
  burin_host host_;
};

/// The services that belong to a plugin's burin_host.
inline HostServices& services(const burin_host* host) { return *static_cast<HostServices*>(host->self); }

}  // namespace burin
