// plugin_check MODULE BRUSH PARAMETER...: fails unless the module exports a plugin whose only brush has this
// id and these parameters.
#include <burin/abi/plugin.h>
#include <dlfcn.h>

#include <cstdio>
#include <string>
#include <vector>

namespace {

std::string summary(const burin_plugin_entry& entry) {
  const auto* factory = static_cast<const burin_brush_factory*>(entry.get_factory(BURIN_BRUSH_FACTORY));
  if (!factory) return "no factory";
  std::string text;
  for (std::uint32_t i = 0; i < factory->brush_count; ++i) {
    const burin_brush_descriptor& brush = *factory->brushes[i];
    text += std::string(" ") + brush.id;
    for (std::uint32_t j = 0; j < brush.param_count; ++j) text += std::string(" ") + brush.params[j]->id;
  }
  return text;
}

int fail(const std::string& line) {
  std::fprintf(stderr, "plugin_check: %s\n", line.c_str());
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  std::string expected;
  for (std::size_t i = 1; i < arguments.size(); ++i) expected += " " + arguments[i];

  void* module = dlopen(arguments.at(0).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!module) return fail(dlerror());
  const auto* entry = static_cast<const burin_plugin_entry*>(dlsym(module, BURIN_PLUGIN_SYMBOL));
  if (!entry) return fail(dlerror());
  if (entry->abi_major != BURIN_ABI_MAJOR) return fail("another ABI");
  if (entry->init(argv[1], nullptr) != BURIN_OK) return fail("init failed");
  const std::string found = summary(*entry);
  entry->deinit();
  return found == expected ? 0 : fail("expected" + expected + ", found" + found);
}
