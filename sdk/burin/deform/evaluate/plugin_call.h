#pragma once
#include <string>

namespace burin {

/// Marks, during its lifetime, that the calling thread runs code of a plugin, so that a host can report which
/// plugin called exit(). Calls may nest. Both texts must outlive the object.
class PluginCall {
 public:
  /// `kind` and `name`: "brush", "org.example.ripple".
  PluginCall(const char* kind, const char* name);
  ~PluginCall();
  PluginCall(const PluginCall&) = delete;
  PluginCall& operator=(const PluginCall&) = delete;

  /// The plugin whose code the calling thread runs, "brush org.example.ripple"; empty if none.
  static std::string running();

 private:
  struct Plugin {
    const char *kind, *name;
  };
  static thread_local Plugin current;
  Plugin before_;
};

}  // namespace burin
