// Finds the frames of a plugin's module on a stack.
#include "validate/probe/stack_places.h"

#include <dlfcn.h>
#include <execinfo.h>
#include <fmt/format.h>

namespace burin::validate {
namespace {

/// Where a frame's code lies.
struct Place {
  const char* file = nullptr;  ///< start of the file in memory
  bool exported = false;       ///< in a function that the file exports
};

Place place_of(const void* address) {
  Dl_info info{};
  if (dladdr(address, &info) == 0) return {};
  return {static_cast<const char*>(info.dli_fbase), info.dli_sname != nullptr};
}

}  // namespace

Stack stack_here() {
  Stack stack;
  stack.depth = backtrace(stack.addresses.data(), static_cast<int>(stack.addresses.size()));
  return stack;
}

std::string places_in_module(const Stack& stack, const void* address) {
  const char* const module = place_of(address).file;
  const char* const program = place_of(reinterpret_cast<const void*>(&stack_here)).file;
  std::string places;
  bool innermost = true;  // The functions that look at the stack are the program's.
  for (int i = 0; i < stack.depth; ++i) {
    const char* returns_to = static_cast<const char*>(stack.addresses[static_cast<std::size_t>(i)]);
    const Place place = place_of(returns_to - 1);
    // Modules use functions of the C++ library that the program exports.
    const bool services = place.file == program && !place.exported;
    innermost = innermost && services;
    if (services && !innermost) break;
    // One byte before the place that the call returns to is the call.
    if (place.file == module)
      places += fmt::format("{}{:#x}", places.empty() ? "" : " < ", returns_to - 1 - module);
  }
  return places;
}

}  // namespace burin::validate
