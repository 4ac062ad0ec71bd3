// Keeps the plugin whose code runs in a variable of the thread.
#include <burin/deform/evaluate/plugin_call.h>

#include <utility>

namespace burin {

thread_local RunningPlugin PluginCall::current{nullptr, nullptr};

PluginCall::PluginCall(const char* kind, const char* name) : before_(std::exchange(current, {kind, name})) {}

PluginCall::~PluginCall() { current = before_; }

}  // namespace burin
