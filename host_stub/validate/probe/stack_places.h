#pragma once
#include <array>
#include <string>

namespace burin::validate {

/// The return addresses of a thread, innermost first.
struct Stack {
  std::array<void*, 32> addresses{};
  int depth = 0;
};

/// The stack of the caller. From the second call on it neither allocates nor locks.
Stack stack_here();

/// The places of a stack in the file of the module that holds `address`, innermost first, for addr2line:
/// "0x1234 < 0x1400". Empty if the module is not there or called this program, which did the rest.
std::string places_in_module(const Stack& stack, const void* address);

}  // namespace burin::validate
