#pragma once
#include <burin/base/vector.h>

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// A .gltf or .glb file with its buffers, and the numbers of its accessors [Khronos, glTF 2.0].
class GltfDocument {
 public:
  /// Throws FileError: not of version 2, a chunk or buffer that is missing or too short, an extension
  /// required that is not known, Draco and meshopt among them.
  explicit GltfDocument(const std::filesystem::path& path);

  const nlohmann::json& json() const { return json_; }

  /// The element of a list of the document, "meshes", "nodes". Throws FileError when it is not there.
  const nlohmann::json& element(const char* list, const nlohmann::json& index) const;

  /// The numbers of an accessor, whatever it is made of: integers, normalised or not, interleaved, sparse.
  struct Values {
    std::size_t components = 0;  ///< of each element, 1 to 4
    std::vector<double> numbers;
    std::size_t size() const { return components == 0 ? 0 : numbers.size() / components; }
  };
  Values values(const nlohmann::json& accessor_index) const;

  /// Bytes of the file and of its buffers.
  std::size_t size() const { return size_; }

  [[noreturn]] void fail(std::string_view place, std::string_view what) const;

 private:
  void read_glb(std::string bytes);
  void check_extensions() const;
  void load_buffers();
  std::string buffer_of_uri(const std::string& uri, std::size_t buffer) const;

  /// So many bytes of a view, which lie in its buffer.
  struct View {
    std::string_view bytes;
    std::size_t stride;  ///< 0: as the elements are wide
  };
  View view(const nlohmann::json& index) const;
  void read_dense(const nlohmann::json& accessor, Values& values) const;
  void read_sparse(const nlohmann::json& accessor, Values& values) const;

  std::filesystem::path path_;
  nlohmann::json json_;
  std::string glb_buffer_;
  std::vector<std::string> buffers_;
  std::size_t size_ = 0;  ///< bytes of all files
};

}  // namespace burin
