#pragma once
#include <string>

namespace burin {

/// Marks that the calling thread runs code of a plugin, as long as it lives, so that a host can name who
/// called exit() in it. Calls may nest. Both texts must outlive it.
class PluginCall {
 public:
  /// `kind` and `name`: "brush", "org.example.ripple".
  PluginCall(const char* kind, const char* name);
  ~PluginCall();
  PluginCall(const PluginCall&) = delete;
  PluginCall& operator=(const PluginCall&) = delete;

  /// Whose code the calling thread runs, "brush org.example.ripple"; empty where none.
  static std::string running();

 private:
  struct Plugin {
    const char *kind, *name;
  };
  static thread_local Plugin current;
  Plugin before_;
};

}  // namespace burin
