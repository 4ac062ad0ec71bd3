#pragma once
#include <burin/host/isolate/shared_memory.h>

#include <filesystem>

namespace burin::process {

/// From now on a signal that ends this process, a call of exit() and SIGUSR2, by which the host asks a
/// thread where it is, are told in the record.
void tell_crashes(isolate::CrashRecord& record);

/// The calling thread gets a stack for the signal handlers, so that they run when its own is full.
void use_handler_stack();

/// Names the library whose functions are told: those of the brush. Call it before its code runs, and again
/// when it is loaded.
void tell_functions_of(const std::filesystem::path& module);

/// From here on exit() is no fault.
void expect_exit();

}  // namespace burin::process
