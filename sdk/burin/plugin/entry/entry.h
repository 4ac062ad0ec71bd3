#pragma once
#include <burin/plugin/entry/module.h>

/// Exports brush classes from a module. Use it once per module, at global scope.
///
///   BURIN_PLUGIN(Groove, Scales);
///
/// The classes may be in anonymous namespaces.
#define BURIN_PLUGIN(...)                           \
  namespace {                                       \
  struct BurinModuleTag {};                         \
  }                                                 \
  constinit const burin_plugin_entry burin_plugin = \
      ::burin::plugin::detail::Module<BurinModuleTag, __VA_ARGS__>::entry()
