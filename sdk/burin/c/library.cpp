// Brush libraries for C, whose brushes have stamps and lettering, and may make solids.
#include <burin/base/program_file.h>
#include <burin/host/c/call.h>
#include <burin/host/c/handles.h>
#include <burin/host/c/lent_threads.h>
#include <burin/host/plugin/utf8_path.h>
#include <burin/services/stamp_services.h>
#include <burin/solid_module/loaded_solids.h>
#include <burin/version.h>

#include <cstddef>
#include <filesystem>
#include <utility>

namespace burin::c {
namespace {

namespace fs = std::filesystem;

/// A log that passes lines on to a function of C.
BrushLibrary::Log log_of(const burin_library_options& options) {
  if (!options.log) return {};
  return [write = options.log, user = options.user](int severity, std::string_view line) {
    write(user, severity, std::string(line).c_str());
  };
}

/// What 0 stands for is the default.
double seconds_of(double given, double otherwise, const char* name) {
  if (given == 0) return otherwise;
  if (!(given > 0)) reject(std::string(name) + " is not above 0");
  return given;
}

Isolation isolation_of(const burin_library_options& options) {
  Isolation isolation;
  if (options.brush_process) isolation.program = path_from_utf8(options.brush_process);
  isolation.load_seconds = seconds_of(options.load_seconds, isolation.load_seconds, "load_seconds");
  isolation.call_seconds = seconds_of(options.call_seconds, isolation.call_seconds, "call_seconds");
  isolation.batch_seconds = seconds_of(options.batch_seconds, isolation.batch_seconds, "batch_seconds");
  if (options.memory != 0) isolation.memory = options.memory == UINT64_MAX ? 0 : options.memory;
  return isolation;
}

std::shared_ptr<BrushLibrary> brushes_of(const burin_library_options& options,
                                         std::unique_ptr<HostExtensions> extensions) {
  if (options.isolate > 1) reject("isolate is neither 0 nor 1");
  if (options.isolate == 1) return std::make_shared<BrushLibrary>(log_of(options), isolation_of(options));
  return std::make_shared<BrushLibrary>(log_of(options), std::move(extensions));
}

std::shared_ptr<const TaskRunner> threads_of(const burin_library_options& options) {
  if (!options.run) return nullptr;
  return std::make_shared<LentThreads>(options.run, options.run_user, options.run_threads);
}

std::shared_ptr<const VoxelField> read_vdb(const fs::path& path, const VoxelFieldOptions& options) {
  return solid_tools().read_vdb(TaskRunner::current(), path, options);
}

MergedSolid merge(const SolidMerge& merge) { return solid_tools().merge(TaskRunner::current(), merge); }

void load(burin_library& library, const char* path) {
  if (!path)
    library.brushes->load_search_path(beside_own_file("brushes"));
  else if (fs::is_directory(fs::path(path)))
    library.brushes->load_folder(path);
  else
    library.brushes->load(path);
}

}  // namespace
}  // namespace burin::c

using namespace burin;

burin_status burin_library_create(const burin_library_options* options, burin_library** library,
                                  burin_text* error) {
  return plugin::guarded(error, [&] {
    c::require(library, "library");
    burin_library_options known{};
    if (options)
      known = c::known_members(options, BURIN_HAS(options, burin_library_options, user), "options");
    *library = new burin_library{
        c::brushes_of(known, stamp_services(c::read_vdb)), c::threads_of(known), c::merge, {}};
  });
}

burin_status burin_get_version(burin_version_info* info, burin_text* error) {
  return plugin::guarded(error, [&] {
    const burin_version_info version{.struct_size = 0,
                                     .major = BURIN_C_MAJOR,
                                     .minor = BURIN_C_MINOR,
                                     .abi_major = BURIN_ABI_MAJOR,
                                     .abi_minor = BURIN_ABI_MINOR,
                                     .reserved = 0,
                                     .text = BURIN_VERSION};
    c::give(version, info, info && BURIN_HAS(info, burin_version_info, text), "info");
  });
}

void burin_library_destroy(burin_library* library) { delete library; }

burin_status burin_library_load(burin_library* library, const char* path, burin_text* error) {
  return plugin::guarded(error, [&] {
    c::require(library, "library");
    const auto refresh = [&] { library->refused = library->brushes->refused(); };
    try {
      c::load(*library, path);
    } catch (...) {
      refresh();
      throw;
    }
    refresh();
  });
}

burin_status burin_library_reload(burin_library* library, const char* path, burin_text* error) {
  return plugin::guarded(error, [&] {
    c::require(library, "library");
    c::require(path, "path");
    library->brushes->reload(path);
  });
}

burin_status burin_library_add(burin_library* library, const char* name, const burin_brush_factory* factory,
                               burin_text* error) {
  return plugin::guarded(error, [&] {
    c::require(library, "library");
    c::require(name, "name");
    c::require(factory, "factory");
    library->brushes->add(name, *factory);
  });
}

uint64_t burin_library_brush_count(const burin_library* library) {
  return library ? library->brushes->brushes().size() : 0;
}

const burin_brush_descriptor* burin_library_brush(const burin_library* library, uint64_t index) {
  return index < burin_library_brush_count(library) ? library->brushes->brushes()[index].descriptor : nullptr;
}

uint64_t burin_library_refused_count(const burin_library* library) {
  return library ? library->refused.size() : 0;
}

const char* burin_library_refused(const burin_library* library, uint64_t index) {
  return index < burin_library_refused_count(library) ? library->refused[index].c_str() : nullptr;
}
