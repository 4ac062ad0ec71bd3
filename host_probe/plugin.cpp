// burin_probe: a plugin that tells what its host does wrong. It needs nothing but the headers of the ABI, so
// it can be built for any host. See docs/probe.md.
#include <burin/abi/plugin.h>

#include <atomic>
#include <cstdio>
#include <cstring>

#include "brush.h"
#include "calls.h"
#include "checks/check_host.h"
#include "checks/check_values.h"
#include "descriptors.h"
#include "error_text.h"
#include "report.h"
#include "rules.h"

namespace burin_probe {
namespace {

std::atomic<int> users{0};
std::atomic<unsigned> main_thread{0};

const burin_brush* BURIN_CALL create(const burin_brush_factory* factory, const burin_host* host,
                                     const char* brush_id, burin_text* error);

constexpr burin_brush_factory factory_table{sizeof(burin_brush_factory), brush_count, descriptors, create};

const burin_brush_descriptor* find_descriptor(const char* id) {
  for (const burin_brush_descriptor* descriptor : descriptors)
    if (id && std::strcmp(descriptor->id, id) == 0) return descriptor;
  return nullptr;
}

const burin_brush* BURIN_CALL create(const burin_brush_factory* factory, const burin_host* host,
                                     const char* brush_id, burin_text* error) {
  check_main_thread();
  check_text(error);
  expect(Rule::create_factory, factory == &factory_table && users > 0, "inits", users);
  check_host(host);
  const burin_brush_descriptor* descriptor = find_descriptor(brush_id);
  Brush* brush = descriptor ? take_brush() : nullptr;
  if (!brush) return say(error, descriptor ? "too many brushes" : "no such brush"), nullptr;
  note_call(Call::create, brush->number);
  brush->descriptor = descriptor;
  brush->host = host;
  if (host) brush->host_then = *host;
  brush->state = 7;
  fill(*brush);
  return &brush->abi;
}

/// Whether there is a file of this name.
bool is_file(const char* path) {
  std::FILE* file = path ? std::fopen(path, "rb") : nullptr;
  if (file) std::fclose(file);
  return file;
}

burin_status BURIN_CALL init(const char* plugin_path, burin_text* error) {
  check_main_thread();
  ++users;
  check_text(error);
  note_call(Call::init);
  expect(Rule::init_path, plugin_path && is_utf8(plugin_path) && is_file(plugin_path), "plugin_path");
  return BURIN_OK;
}

void BURIN_CALL deinit() {
  check_main_thread();
  note_call(Call::deinit);
  if (!expect(Rule::init_paired, users > 0, "inits", users) || --users > 0) return;
  const int living = living_brushes();
  expect(Rule::brush_destroyed, living == 0, "brushes", living);
  write_report();
}

const void* BURIN_CALL get_factory(const char* factory_id) {
  check_main_thread();
  note_call(Call::get_factory);
  if (!expect(Rule::factory_when, users > 0 && factory_id, "inits", users)) return nullptr;
  return std::strcmp(factory_id, BURIN_BRUSH_FACTORY) == 0 ? &factory_table : nullptr;
}

/// Writes the report of a host that did not call deinit as often as init, or called the probe after the last.
struct AtUnload {
  ~AtUnload() {
    if (main_thread == 0) return;
    expect(Rule::init_paired, users == 0, "inits", users);
    write_report();
  }
} at_unload;

}  // namespace

void check_main_thread() {
  unsigned none = 0;
  main_thread.compare_exchange_strong(none, thread_number());
  expect(Rule::main_thread, main_thread == thread_number(), "the main thread is", main_thread);
}

}  // namespace burin_probe

extern "C" const burin_plugin_entry burin_plugin = {
    sizeof(burin_plugin_entry), BURIN_ABI_MAJOR,     BURIN_ABI_MINOR,         0,
    burin_probe::init,          burin_probe::deinit, burin_probe::get_factory};
