/* burin/abi/plugin.h - the symbol that a plugin module exports, and the factory behind it.
 *
 * A module is a shared library whose file is named NAME.burin; hosts look for no other files in their
 * folders. It exports BURIN_PLUGIN_SYMBOL and should export nothing else. Weak symbols, which C++ compilers
 * make of inline functions and templates of the standard library, are the exception.
 *
 * A module may be in a process twice, as two files. Loading and the first init take 100 ms at most. A module
 * needs no library that talks to a screen or the network, runs an interpreter or keeps threads: the host has
 * its own. On Linux a module for every host since Debian 12 needs no symbol newer than GLIBC_2.36,
 * GLIBCXX_3.4.30 and CXXABI_1.3.13.
 */
#ifndef BURIN_ABI_PLUGIN_H
#define BURIN_ABI_PLUGIN_H

#include "brush.h"

#ifdef __cplusplus
extern "C" {
#endif
/* Exports a symbol of the module. */
#if defined(_WIN32)
#define BURIN_EXPORT __declspec(dllexport)
#elif defined(__GNUC__)
#define BURIN_EXPORT __attribute__((visibility("default")))
#else
#define BURIN_EXPORT
#endif

/* The name of the exported symbol, a `const burin_plugin_entry`. */
#define BURIN_PLUGIN_SYMBOL "burin_plugin"

/* The id of burin_brush_factory. */
#define BURIN_BRUSH_FACTORY "burin.brush-factory/1"

/* Lists and creates the brushes of a module. Owned by the plugin; lives from init to deinit. */
typedef struct burin_brush_factory {
  uint32_t struct_size;
  uint32_t brush_count;
  const burin_brush_descriptor* const* brushes; /* brush_count pointers */

  /* Creates a brush of the descriptor with this id. On failure returns null and writes a text. The host
   * outlives the brush; brush_id is valid during the call only. [main-thread] */
  const burin_brush*(BURIN_CALL* create)(const struct burin_brush_factory* factory, const burin_host* host,
                                         const char* brush_id, burin_text* error);
} burin_brush_factory;

/* The functions of a plugin module. */
typedef struct burin_plugin_entry {
  uint32_t struct_size;
  uint32_t abi_major; /* BURIN_ABI_MAJOR at the time of compilation */
  uint32_t abi_minor;
  uint32_t reserved;

  /* The host calls this before anything else, and may call it several times, while the module is
   * initialised and again after the last deinit. Each call that returned BURIN_OK is paired with one deinit;
   * the plugin counts them, and only the first initialises. Factories live until the last deinit.
   * plugin_path is the file of the module, UTF-8, for finding resources beside it; it is valid during the
   * call only. [main-thread] */
  burin_status(BURIN_CALL* init)(const char* plugin_path, burin_text* error);

  /* Undoes one init. The last leaves no thread, open file or signal handler, so that the module can be
   * unloaded. [main-thread, every brush destroyed before the last] */
  void(BURIN_CALL* deinit)(void);

  /* Returns the factory with this id (BURIN_BRUSH_FACTORY), or null.
   * [main-thread, between init and deinit] */
  const void*(BURIN_CALL* get_factory)(const char* factory_id);
} burin_plugin_entry;

/* Defined by the plugin module: const burin_plugin_entry burin_plugin = { ... }; */
BURIN_EXPORT extern const burin_plugin_entry burin_plugin;

#ifdef __cplusplus
}
#endif
#endif
