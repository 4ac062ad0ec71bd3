#pragma once
#include <burin/base/vector.h>

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// A .gltf or .glb file [Khronos, glTF 2.0] with its buffers; decodes accessors.
class GltfDocument {
 public:
  /// Reads the file and its buffers. Throws FileError if the version is not 2, if a chunk or buffer is
  /// missing or too short, or if a required extension is not supported (Draco and meshopt compression, for
  /// example).
  explicit GltfDocument(const std::filesystem::path& path);

  const nlohmann::json& json() const { return json_; }

  /// An element of one of the document's lists ("meshes", "nodes", ...). Throws FileError if it does not
  /// exist.
  const nlohmann::json& element(const char* list, const nlohmann::json& index) const;

  /// The numbers of an accessor, converted to double. Integers (normalised or not), interleaved and sparse
  /// accessors are supported.
  struct Values {
    std::size_t components = 0;  ///< numbers per element, 1 to 4, or 16 of a matrix, column by column
    std::vector<double> numbers;
    std::size_t size() const { return components == 0 ? 0 : numbers.size() / components; }
  };
  Values values(const nlohmann::json& accessor_index) const;

  /// The size of the file and of its buffers, bytes.
  std::size_t size() const { return size_; }

  [[noreturn]] void fail(std::string_view place, std::string_view what) const;

 private:
  void read_glb(const std::string& bytes);
  void check_extensions() const;
  void load_buffers();
  std::string buffer_of_uri(const std::string& uri, std::size_t buffer) const;

  /// The bytes of a buffer view.
  struct View {
    std::string_view bytes;
    std::size_t stride;  ///< bytes; 0 means that elements are tightly packed
  };
  View view(const nlohmann::json& index) const;
  void read_dense(const nlohmann::json& accessor, Values& values) const;
  void read_sparse(const nlohmann::json& accessor, Values& values) const;

  std::filesystem::path path_;
  nlohmann::json json_;
  std::string glb_buffer_;
  std::vector<std::string> buffers_;
  std::size_t size_ = 0;  ///< size of all files, bytes
};

}  // namespace burin
