// Reads a property of the vertices of a PLY file, past all that comes before it.
#include <burin/base/error.h>
#include <burin/base/text/lower_case.h>
#include <burin/base/text/quoted_word.h>
#include <burin/surface/files/mesh_formats.h>
#include <burin/surface/formats/ply_header.h>
#include <burin/surface/formats/ply_values.h>
#include <burin/surface/vertex_scalar.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// Calls take(property, value) for all numbers of a row but the lengths of lists.
template <class Take>
void read_row(PlyValues& values, const PlyElement& element, const Take& take) {
  for (const PlyProperty& property : element.properties) {
    const std::uint64_t count = property.count_type ? values.next_count(*property.count_type) : 1;
    for (std::uint64_t i = 0; i < count; ++i) take(property, values.next(property.type));
  }
}

std::string names_of(const PlyElement& element) {
  std::string names;
  for (const PlyProperty& property : element.properties)
    if (!property.count_type) names += (names.empty() ? "" : ", ") + quoted_word(property.name);
  return names;
}

std::vector<float> read_values(PlyValues& values, const PlyElement& element, const PlyProperty& wanted) {
  std::vector<float> result;
  for (std::uint64_t row = 0; row < element.count; ++row) {
    read_row(values, element, [&](const PlyProperty& property, double value) {
      if (&property != &wanted) return;
      result.push_back(static_cast<float>(value));
      if (!std::isfinite(result.back())) throw Error(fmt::format("vertex {}: is not finite", row + 1));
    });
  }
  return result;
}

}  // namespace

std::vector<float> read_vertex_scalar(const std::filesystem::path& path, std::string_view name) {
  if (in_lower_case(path.extension().string()) != ".ply")
    throw FileError(path.string(), "only PLY files have values of their vertices");
  const std::string text = read_mesh_bytes(path);
  const PlyHeader header = read_ply_header(text, path);
  PlyValues values(std::string_view(text).substr(header.size), header.format);
  try {
    for (const PlyElement& element : header.elements) {
      if (element.name == "vertex") {
        const PlyProperty* const wanted = find_property(element, name);
        if (!wanted || wanted->count_type)
          throw Error(
              fmt::format("its vertices have no value {}, only {}", quoted_word(name), names_of(element)));
        return read_values(values, element, *wanted);
      }
      for (std::uint64_t row = 0; row < element.count; ++row)
        read_row(values, element, [](const PlyProperty&, double) {});
    }
  } catch (const FileError&) {
    throw;
  } catch (const Error& error) {
    throw FileError(path.string(), error.what());
  }
  throw FileError(path.string(), "has no element 'vertex'");
}

}  // namespace burin
