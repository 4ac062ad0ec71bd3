#pragma once
#include <cstddef>
#include <filesystem>

namespace burin {

/// What the operating system knows of this process.

/// The folder that holds the running program.
std::filesystem::path executable_folder();

/// The most physical memory that the process has held so far, bytes.
std::size_t peak_memory();

/// Since the system started the process, loading of libraries included.
double seconds_since_process_start();

bool stderr_is_terminal();

}  // namespace burin
