#pragma once

namespace burin {

/// A plugin whose code runs: "brush", "org.example.ripple". Both are null if none runs.
struct RunningPlugin {
  const char *kind, *name;
};

/// Marks, during its lifetime, that the calling thread runs code of a plugin, so that a host can report which
/// plugin called exit() or crashed. Calls may nest. Both texts must outlive the object.
class PluginCall {
 public:
  /// `kind` and `name`: "brush", "org.example.ripple".
  PluginCall(const char* kind, const char* name);
  ~PluginCall();
  PluginCall(const PluginCall&) = delete;
  PluginCall& operator=(const PluginCall&) = delete;

  /// The plugin whose code the calling thread runs. Signal handlers may call it.
  static RunningPlugin running() { return current; }

 private:
  static thread_local RunningPlugin current;
  RunningPlugin before_;
};

}  // namespace burin
