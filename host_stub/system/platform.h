#pragma once
#include <cstddef>
#include <cstdio>

namespace burin {

// Queries of the operating system about this process.

/// The greatest physical memory of the process so far, bytes.
std::size_t peak_memory();

/// The current physical memory of the process, bytes, after free parts of the heap were returned to the
/// system.
std::size_t resident_memory();

/// The physical memory available to processes, bytes; 0 if unknown.
std::size_t memory_limit();

/// The time since the system started the process, including the loading of libraries.
double seconds_since_process_start();

/// The processor time that this thread has used.
double thread_seconds();

/// Whether a debugger is attached to the process.
bool is_debugged();

bool stderr_is_terminal();

/// Opens the standard streams that are closed at the start of the process, so that no other file gets their
/// descriptors. Writing to such a standard output fails.
void open_standard_streams();

/// Redirects the standard output to stderr, and returns a stream to the original standard output. Returns
/// null, and changes nothing, if no more files can be opened.
std::FILE* divert_standard_output();

}  // namespace burin
