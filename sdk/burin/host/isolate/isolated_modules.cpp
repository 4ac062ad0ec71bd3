// Chooses by the system.
#include <burin/base/error.h>
#include <burin/host/isolate/isolated_modules.h>

#include <utility>

#if defined(__linux__)
#include <burin/host/isolate/isolated_module.h>
#include <fmt/format.h>

namespace burin::isolate {
namespace {

class LinuxModules : public IsolatedModules {
 public:
  LinuxModules(const Isolation& isolation, Log log) : isolation_(isolation), log_(std::move(log)) {}

  std::shared_ptr<const BrushModule> open(const std::filesystem::path& module) override {
    if (!reader_) reader_.emplace(isolation_, log_);
    return std::make_shared<const IsolatedModule>(module, *reader_, isolation_, log_);
  }
  void rest() override { reader_.reset(); }

 private:
  Isolation isolation_;
  Log log_;
  std::optional<DescriptorReader> reader_;
};

void check(double seconds, const char* name) {
  if (!(seconds > 0)) throw ContractError(fmt::format("{} must be above 0, not {}", name, seconds));
}

}  // namespace

std::unique_ptr<IsolatedModules> isolated_modules(const Isolation& isolation, Log log) {
  check(isolation.load_seconds, "the time to load a brush");
  check(isolation.call_seconds, "the time of a brush's call");
  check(isolation.batch_seconds, "the time of a brush's batch");
  return std::make_unique<LinuxModules>(isolation, std::move(log));
}

}  // namespace burin::isolate
#else
namespace burin::isolate {

std::unique_ptr<IsolatedModules> isolated_modules(const Isolation&, BrushLibrary::Log) {
  throw Error("brushes in processes of their own need Linux");
}

}  // namespace burin::isolate
#endif
