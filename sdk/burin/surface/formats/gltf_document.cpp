// Parses the container of a glTF or GLB file: JSON, chunks, buffers (embedded, base64 or beside the file),
// and decodes accessors to doubles. Every offset and count is checked before it is used.
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/base/text/base64.h>
#include <burin/base/text/quoted_word.h>
#include <burin/surface/files/little_endian.h>
#include <burin/surface/files/mesh_formats.h>
#include <burin/surface/formats/gltf_document.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace burin {

using Json = nlohmann::json;

namespace {

/// A member that is a count; `initial` if it is missing. Throws Error if it is not a whole number.
std::size_t count_of(const Json& object, const char* name, std::size_t initial) {
  const auto found = object.find(name);
  if (found == object.end()) return initial;
  if (!found->is_number_unsigned()) throw Error(fmt::format("'{}' is no whole number above 0", name));
  return found->get<std::size_t>();
}

std::string text_of(const Json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::size_t components_of(const std::string& type) {
  if (type == "MAT4") return 16;
  constexpr std::array<std::string_view, 4> types = {"SCALAR", "VEC2", "VEC3", "VEC4"};
  const auto found = std::ranges::find(types, type);
  if (found == types.end())
    throw Error(fmt::format("its type {} is none of numbers here", quoted_word(type)));
  return static_cast<std::size_t>(found - types.begin()) + 1;
}

enum ComponentType : std::size_t {
  int8 = 5120,
  uint8 = 5121,
  int16 = 5122,
  uint16 = 5123,
  uint32 = 5125,
  float32 = 5126
};

std::size_t size_of(std::size_t type) {
  switch (type) {
    case int8:
    case uint8:
      return 1;
    case int16:
    case uint16:
      return 2;
    case uint32:
    case float32:
      return 4;
    default:
      throw Error(fmt::format("its component type {} is unknown", type));
  }
}

double value_at(std::string_view bytes, std::size_t at, std::size_t type, bool normalised) {
  const std::uint32_t bits = little_endian(bytes, at, size_of(type));
  const auto scaled = [&](double value, double full) {
    return normalised ? std::max(value / full, -1.0) : value;
  };
  switch (type) {
    case int8:
      return scaled(static_cast<std::int8_t>(bits), 127);
    case uint8:
      return scaled(bits, 255);
    case int16:
      return scaled(static_cast<std::int16_t>(bits), 32767);
    case uint16:
      return scaled(bits, 65535);
    case uint32:
      return bits;
    default:
      return std::bit_cast<float>(bits);
  }
}

/// Decodes percent-encoding, as in "%20".
std::string from_percents(const std::string& text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string digits = text.substr(std::min(i + 1, text.size()), 2);
    const bool coded = text[i] == '%' && digits.size() == 2 &&
                       digits.find_first_not_of("0123456789abcdefABCDEF") == std::string::npos;
    plain.push_back(coded ? static_cast<char>(std::stoi(digits, nullptr, 16)) : text[i]);
    if (coded) i += 2;
  }
  return plain;
}

}  // namespace

GltfDocument::GltfDocument(const std::filesystem::path& path) : path_(path) {
  const std::string bytes = read_mesh_bytes(path);
  size_ = bytes.size();
  try {
    if (bytes.starts_with("glTF")) {
      read_glb(bytes);
    } else {
      json_ = Json::parse(bytes);
    }
    if (!json_.is_object() || !text_of(json_.value("asset", Json::object()), "version").starts_with("2."))
      throw Error("is not glTF of version 2");
    check_extensions();
    load_buffers();
  } catch (const Json::parse_error& error) {
    throw FileError(path.string(), fmt::format("byte {}", error.byte), "is not JSON");
  } catch (const Json::exception&) {
    throw FileError(path.string(), "is not glTF: a member is of another type");
  } catch (const FileError&) {
    throw;
  } catch (const Error& error) {
    throw FileError(path.string(), error.what());
  }
}

void GltfDocument::fail(std::string_view place, std::string_view what) const {
  throw FileError(path_.string(), place, what);
}

void GltfDocument::read_glb(const std::string& bytes) {
  if (bytes.size() < 20 || little_endian(bytes, 4) != 2) throw Error("is not GLB of version 2");
  constexpr std::uint32_t json_chunk = 0x4e4f534a, binary_chunk = 0x004e4942;
  for (std::size_t at = 12; at + 8 <= bytes.size();) {
    const std::size_t size = little_endian(bytes, at);
    const std::uint32_t type = little_endian(bytes, at + 4);
    at += 8;
    if (size > bytes.size() - at) throw Error(fmt::format("is cut off: a chunk has {} bytes more", size));
    if (type == json_chunk && json_.is_null()) json_ = Json::parse(bytes.substr(at, size));
    if (type == binary_chunk && glb_buffer_.empty()) glb_buffer_ = bytes.substr(at, size);
    at += size;
  }
}

void GltfDocument::check_extensions() const {
  // These extensions describe appearance, animation or metadata only, or are supported; shapes are complete
  // without the former.
  constexpr std::string_view known[] = {
      "KHR_mesh_quantization", "KHR_texture_transform", "KHR_materials_",   "KHR_lights_punctual",
      "KHR_texture_basisu",    "EXT_texture_webp",      "EXT_texture_avif", "MSFT_texture_dds",
      "KHR_technique",         "KHR_animation_pointer", "KHR_xmp"};
  for (const Json& name : json_.value("extensionsRequired", Json::array())) {
    const auto text = name.get<std::string>();
    if (text == "KHR_draco_mesh_compression")
      throw Error("is compressed by Draco (KHR_draco_mesh_compression), which is not read");
    if (text == "EXT_meshopt_compression" || text == "KHR_meshopt_compression")
      throw Error(fmt::format("is compressed by meshoptimizer ({}), which is not read", text));
    if (std::ranges::none_of(known, [&](std::string_view begin) { return text.starts_with(begin); }))
      throw Error(fmt::format("needs the extension {}, which is not known", quoted_word(text)));
  }
}

void GltfDocument::load_buffers() {
  for (const Json& buffer : json_.value("buffers", Json::array())) {
    const std::size_t number = buffers_.size(), length = count_of(buffer, "byteLength", 0);
    const std::string uri = text_of(buffer, "uri");
    buffers_.push_back(uri.empty() && number == 0 ? std::move(glb_buffer_) : buffer_of_uri(uri, number));
    size_ += buffers_.back().size();
    if (buffers_.back().size() < length)
      throw Error(
          fmt::format("buffer {} is cut off: {} of {} bytes", number, buffers_.back().size(), length));
  }
}

std::string GltfDocument::buffer_of_uri(const std::string& uri, std::size_t buffer) const {
  if (uri.starts_with("data:")) {
    const std::size_t comma = uri.find(";base64,");
    if (comma == std::string::npos)
      throw Error(fmt::format("buffer {} has a URI that is not base64", buffer));
    return from_base64(std::string_view(uri).substr(comma + 8)).value_or("");
  }
  const std::filesystem::path name = from_percents(uri);
  const bool beside = !uri.empty() && name.is_relative() && uri.find("://") == std::string::npos &&
                      std::ranges::find(name, std::filesystem::path("..")) == name.end();
  if (!beside)
    throw Error(fmt::format("buffer {} is {}, which is no file beside this one", buffer, quoted_word(uri)));
  return read_mesh_bytes(path_.parent_path() / name);
}

const Json& GltfDocument::element(const char* list, const Json& index) const {
  const auto found = json_.find(list);
  const std::size_t count = found == json_.end() || !found->is_array() ? 0 : found->size();
  if (!index.is_number_unsigned() || index.get<std::size_t>() >= count)
    fail(list, fmt::format("{} is not among the {}", quoted_word(index.dump()), count));
  return (*found)[index.get<std::size_t>()];
}

GltfDocument::View GltfDocument::view(const Json& index) const {
  const Json& view = element("bufferViews", index);
  element("buffers", view.value("buffer", Json()));
  const std::string_view buffer = buffers_[view["buffer"].get<std::size_t>()];
  const std::size_t offset = count_of(view, "byteOffset", 0), length = count_of(view, "byteLength", 0);
  if (offset > buffer.size() || length > buffer.size() - offset)
    throw Error("its buffer view reaches beyond the buffer");
  return {buffer.substr(offset, length), count_of(view, "byteStride", 0)};
}

GltfDocument::Values GltfDocument::values(const Json& accessor_index) const {
  const Json& accessor = element("accessors", accessor_index);
  const std::string place = fmt::format("accessor {}", accessor_index.get<std::size_t>());
  try {
    Values values;
    values.components = components_of(text_of(accessor, "type"));
    const std::size_t count = count_of(accessor, "count", 0);
    // An accessor without data is all zeros, so its count must be limited by something else.
    if (count > size_) throw Error(fmt::format("has {} elements, more than the file has bytes", count));
    values.numbers.assign(count * values.components, 0);
    if (accessor.contains("bufferView")) read_dense(accessor, values);
    if (accessor.contains("sparse")) read_sparse(accessor, values);
    return values;
  } catch (const FileError&) {
    throw;
  } catch (const Error& error) {
    fail(place, error.what());
  } catch (const Json::exception&) {
    fail(place, "a member is of another type");
  }
}

namespace {

/// Reads elements whose starts are `stride` bytes apart.
struct Run {
  std::string_view bytes;
  std::size_t offset, stride, components, type;
  bool normalised;

  Run(std::string_view in, std::size_t from, std::size_t apart, std::size_t of_each, std::size_t of_type,
      bool scale, std::size_t count)
      : bytes(in), offset(from), stride(apart), components(of_each), type(of_type), normalised(scale) {
    const std::size_t width = components * size_of(type);
    if (stride == 0) stride = width;
    const std::size_t room = offset <= bytes.size() ? bytes.size() - offset : 0;
    if (stride < width || (count > 0 && (room < width || (room - width) / stride < count - 1)))
      throw Error("reaches beyond its buffer view");
  }

  double at(std::size_t element, std::size_t component) const {
    return value_at(bytes, offset + element * stride + component * size_of(type), type, normalised);
  }
};

}  // namespace

void GltfDocument::read_dense(const Json& accessor, Values& values) const {
  const View from = view(accessor["bufferView"]);
  const Run run(from.bytes, count_of(accessor, "byteOffset", 0), from.stride, values.components,
                count_of(accessor, "componentType", 0), accessor.value("normalized", false), values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    for (std::size_t k = 0; k < values.components; ++k)
      values.numbers[i * values.components + k] = run.at(i, k);
}

void GltfDocument::read_sparse(const Json& accessor, Values& values) const {
  const Json& sparse = accessor["sparse"];
  const std::size_t count = count_of(sparse, "count", 0);
  if (count > values.size()) throw Error("has more sparse elements than elements");
  const Json &indices = sparse.at("indices"), &others = sparse.at("values");
  const Run at(view(indices.value("bufferView", Json())).bytes, count_of(indices, "byteOffset", 0), 0, 1,
               count_of(indices, "componentType", 0), false, count);
  const Run run(view(others.value("bufferView", Json())).bytes, count_of(others, "byteOffset", 0), 0,
                values.components, count_of(accessor, "componentType", 0),
                accessor.value("normalized", false), count);
  for (std::size_t i = 0; i < count; ++i) {
    const double element = at.at(i, 0);
    if (!(element >= 0 && element < static_cast<double>(values.size())))
      throw Error(fmt::format("has a sparse element {} of {}", element, values.size()));
    for (std::size_t k = 0; k < values.components; ++k)
      values.numbers[static_cast<std::size_t>(element) * values.components + k] = run.at(i, k);
  }
}

}  // namespace burin
