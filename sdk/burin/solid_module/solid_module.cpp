// Implements the entry point of the module burin-solids.so.
#include <burin/base/threads/without_workers.h>
#include <burin/level_set/solid_mesh.h>
#include <burin/solid_module/solid_module.h>
#include <burin/version.h>

#include <string_view>

namespace burin {
namespace {

/// Lent threads as the loops of this module see them. The module has its own TaskRunner::current(), which the
/// one who lends cannot set in tasks.
class LentToModule final : public TaskRunner {
 public:
  explicit LentToModule(const TaskRunner& lent) : lent_(lent) {}

  std::size_t threads() const override { return lent_.threads(); }
  void run(std::size_t count, const std::function<void(std::size_t)>& task) const override {
    lent_.run(count, [&](std::size_t number) { run_undivided(task, number); });
  }

 private:
  const TaskRunner& lent_;
};

/// Calls `tool` with its loops on lent threads, if there are any, and those of OpenVDB on the calling thread.
template <auto tool, class... Arguments>
auto on_threads(const TaskRunner* lent, const Arguments&... arguments) {
  if (!lent) return tool(arguments...);
  const LentToModule runner(*lent);
  return without_workers([&] {
    const TaskRunnerScope scope(&runner);
    return tool(arguments...);
  });
}

}  // namespace
}  // namespace burin

const burin::SolidTools* burin_solid_tools(const char* version) {
  using namespace burin;
  static constexpr SolidTools tools{on_threads<merge_solid, SolidMerge>, on_threads<mesh_of, StrokeSolid>,
                                    on_threads<read_vdb, std::filesystem::path, VoxelFieldOptions>};
  return std::string_view(version) == BURIN_VERSION ? &tools : nullptr;
}
