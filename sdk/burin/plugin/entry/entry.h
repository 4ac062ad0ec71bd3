#pragma once
#include <burin/plugin/entry/module.h>

/// Exports brush classes from a module: once a module, at global scope, in one source.
///
///   BURIN_PLUGIN(Groove, Scales);
///
/// The classes may live in anonymous namespaces.
#define BURIN_PLUGIN(...)                           \
  namespace {                                       \
  struct BurinModuleTag {};                         \
  }                                                 \
  constinit const burin_plugin_entry burin_plugin = \
      ::burin::plugin::detail::Module<BurinModuleTag, __VA_ARGS__>::entry()
