#pragma once
#include <cstddef>
#include <cstdio>
#include <filesystem>

namespace burin {

/// What the operating system knows of this process.

/// The running program's file, and the folder that holds it.
std::filesystem::path executable_file();
std::filesystem::path executable_folder();

/// The most physical memory that the process has held so far, bytes.
std::size_t peak_memory();

/// The physical memory that the process holds now, bytes, after free parts of the heap went back to the
/// system.
std::size_t resident_memory();

/// The physical memory that processes can have here, bytes; 0 where the system does not tell.
std::size_t memory_limit();

/// Since the system started the process, loading of libraries included.
double seconds_since_process_start();

bool stderr_is_terminal();

/// Opens those of the three standard streams that the process was started without, so that no file takes
/// their place. Writing to such a standard output fails.
void open_standard_streams();

/// Lets the process's standard output go to stderr, and returns what leads to where it went before. Null
/// where the system has no more files: it is as before then.
std::FILE* divert_standard_output();

}  // namespace burin
