#pragma once
#include <burin/stroke/recording.h>

#include <filesystem>
#include <span>
#include <string>

namespace burin::command {

/// Replaces a `.stroke` file by one of this recording.
void write_stroke_file(const std::filesystem::path& path, const Recording& recording);

/// The ending of a file's name, by which its kind is chosen, in lower case and without the dot.
std::string written_kind(const std::filesystem::path& path);

/// Throws FileError unless write_pen_file() can write a file of this name.
void check_pen_file_name(const std::filesystem::path& path);

/// Replaces a file by the strokes of recordings as InkML or CSV, as its extension says.
void write_pen_file(const std::filesystem::path& path, std::span<const Recording> recordings);

}  // namespace burin::command
