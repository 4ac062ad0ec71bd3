#pragma once
#include <burin/host/isolate/descriptor_message.h>
#include <burin/host/isolate/isolated_brush.h>
#include <burin/host/plugin/brush_module.h>

#include <memory>
#include <optional>

namespace burin::isolate {

/// Reads the descriptors of modules in a process that it starts for the first and keeps for the next, so that
/// many modules take little longer than in this process. A module that fails there is asked again in a
/// process that has loaded no other, so that none pays for another's faults.
class DescriptorReader {
 public:
  DescriptorReader(const Isolation& isolation, Log log);

  /// The message of the module's descriptors. Throws FileError with the reason if it cannot be loaded.
  Bytes read(const std::filesystem::path& module);

 private:
  Answer ask(const std::filesystem::path& module);

  Isolation isolation_;
  Log log_;
  std::unique_ptr<BrushProcess> process_;
  bool used_ = false;
};

/// A module whose code never runs in this process.
class IsolatedModule : public BrushModule {
 public:
  /// Throws FileError with the reason if it cannot be loaded.
  IsolatedModule(std::filesystem::path path, DescriptorReader& reader, const Isolation& isolation, Log log);

  const std::filesystem::path& path() const override { return path_; }
  std::span<const burin_brush_descriptor* const> brushes() const override { return descriptors_->brushes(); }
  const burin_brush* create(const burin_host* host, const char* brush_id, burin_text* error) const override;

 private:
  std::filesystem::path path_;
  Isolation isolation_;
  Log log_;
  Bytes message_;
  std::optional<ReceivedDescriptors> descriptors_;
};

}  // namespace burin::isolate
