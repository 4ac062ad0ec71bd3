#pragma once
#include <burin/host/c/burin.h>
#include <burin/stroke/recording.h>
#include <burin/surface/triangle_mesh.h>
#include <dlfcn.h>

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "host/sessions.h"

namespace burin::test {

/// libburin.so, or a copy of it, loaded as applications load it that do not link with it. It is never
/// unloaded.
class CLibrary {
 public:
  /// `flags`: of dlopen, besides.
  explicit CLibrary(const std::string& file, int flags = 0)
      : handle_(dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | flags)) {
    if (!handle_) throw std::runtime_error(dlerror());
  }

  template <class Function>
  Function* find(const char* name) const {
    auto* const function = reinterpret_cast<Function*>(dlsym(handle_, name));
    if (!function) throw std::runtime_error(std::string("no ") + name);
    return function;
  }

 private:
  void* handle_;
};

inline const CLibrary& c_library() {
  static const CLibrary library(BURIN_C_LIBRARY);
  return library;
}

/// The function of libburin.so with this name: IN_C(burin_session_end)(session, error).
#define IN_C(name) ::burin::test::c_library().find<decltype(name)>(#name)

/// A buffer for the texts of calls.
struct CText {
  std::array<char, 400> line{};
  burin_text text{sizeof text, static_cast<uint32_t>(line.size()), line.data()};

  burin_text* operator&() {
    line[0] = '\0';
    return &text;
  }
  std::string str() const { return line.data(); }
};

/// The struct with its size, and the rest zero.
template <class Struct>
Struct sized() {
  Struct made{};
  made.struct_size = sizeof made;
  return made;
}

/// The stock brushes and those of tests, as sessions.h has them. Lives until the program ends.
inline burin_library* c_brushes() {
  static burin_library* const library = [] {
    burin_library* made = nullptr;
    CText error;
    const auto load = [&](const std::filesystem::path& path) {
      if (IN_C(burin_library_load)(made, path.c_str(), &error) != BURIN_OK)
        throw std::runtime_error(error.str());
    };
    if (IN_C(burin_library_create)(nullptr, &made, &error) != BURIN_OK) throw std::runtime_error(error.str());
    load(brushes_folder);
    for (const char* brush : {"every_input.burin", "raise_to.burin"}) load(test_brushes_folder / brush);
    load(test_plugins_folder / "error_brush.burin");
    return made;
  }();
  return library;
}

/// The arrays of faces of one size, whose corners are numbers of 32 bits. They must outlive the result.
inline burin_mesh arrays_of(const std::vector<Vec3f>& positions, const void* corners, std::size_t face_count,
                            std::uint32_t face_size) {
  auto arrays = sized<burin_mesh>();
  arrays.position_type = BURIN_FLOAT32;
  arrays.positions = positions.data();
  arrays.vertex_count = positions.size();
  arrays.corner_type = BURIN_UINT32;
  arrays.corners = corners;
  arrays.face_count = face_count;
  arrays.face_size = face_size;
  return arrays;
}

/// The arrays of a mesh of triangles. The mesh must outlive them.
inline burin_mesh arrays_of(const TriangleMesh& mesh) {
  return arrays_of(mesh.positions, mesh.triangles.data(), mesh.triangles.size(), 3);
}

/// A session of libburin.so whose calls must succeed, unless a test calls by itself.
class CSession {
 public:
  explicit CSession(const burin_mesh& mesh) {
    check(IN_C(burin_session_create)(c_brushes(), &mesh, &session_, &error));
  }
  explicit CSession(const TriangleMesh& mesh) : CSession(arrays_of(mesh)) {}
  CSession(const CSession&) = delete;
  CSession& operator=(const CSession&) = delete;
  ~CSession() { IN_C(burin_session_destroy)(session_); }

  operator burin_session*() const { return session_; }

  burin_status try_begin(const std::vector<const char*>& settings, std::uint32_t fields = 0) {
    std::vector<const char*> texts = settings;
    texts.push_back(nullptr);
    auto stroke = sized<burin_stroke>();
    stroke.fields = fields;
    stroke.settings = texts.data();
    return IN_C(burin_session_begin)(session_, &stroke, &error);
  }
  void begin(const std::vector<const char*>& settings,
             std::uint32_t fields = BURIN_PEN_PRESSURE | BURIN_PEN_TILT) {
    check(try_begin(settings, fields));
  }
  burin_status try_add(const std::vector<burin_sample>& samples) {
    return IN_C(burin_session_add)(session_, samples.data(), samples.size(), nullptr, &error);
  }
  void add(const std::vector<burin_sample>& samples) { check(try_add(samples)); }
  void end() { check(IN_C(burin_session_end)(session_, &error)); }
  void draw(const std::vector<const char*>& settings, const std::vector<burin_sample>& samples) {
    begin(settings);
    for (const burin_sample& sample : samples) add({sample});
    end();
  }

  std::uint64_t hash() {
    std::uint64_t hash = 0;
    check(IN_C(burin_session_hash)(session_, &hash, &error));
    return hash;
  }
  burin_session_info info() {
    auto info = sized<burin_session_info>();
    check(IN_C(burin_session_get_info)(session_, &info, &error));
    return info;
  }

  /// All current values of an attribute that has `size` of them at each vertex.
  std::vector<float> read(burin_attribute attribute, std::size_t size) {
    std::vector<float> values(size * info().vertex_count);
    auto target = sized<burin_target>();
    target.type = BURIN_FLOAT32;
    target.data = values.data();
    const burin_range all{0, info().vertex_count};
    check(IN_C(burin_session_read)(session_, attribute, &all, &target, &error));
    return values;
  }
  std::vector<burin_range> update(burin_attribute attribute, std::uint64_t gap = 0,
                                  std::size_t capacity = 1 << 20) {
    std::vector<burin_range> ranges(capacity);
    std::uint64_t count = 0;
    check(IN_C(burin_session_update)(session_, attribute, gap, ranges.data(), capacity, &count, &error));
    ranges.resize(count);
    return ranges;
  }

  void check(burin_status status) {
    if (status != BURIN_OK) throw std::runtime_error(error.str());
  }

  CText error;

 private:
  burin_session* session_ = nullptr;
};

/// Samples as C has them.
inline std::vector<burin_sample> in_c(const std::vector<Sample>& samples) {
  std::vector<burin_sample> made;
  for (const Sample& from : samples) {
    auto sample = sized<burin_sample>();
    sample.time = from.time;
    for (int k = 0; k < 3; ++k) sample.position[k] = from.position[k];
    sample.pressure = from.pen.pressure;
    sample.tilt_x = from.pen.tilt_x;
    sample.tilt_y = from.pen.tilt_y;
    made.push_back(sample);
  }
  return made;
}

// Settings of strokes.
inline const std::vector<const char*> groove = {"brush=org.burin.groove", "radius=0.15"};
/// Moves, paints and masks.
inline const std::vector<const char*> every_input = {"brush=org.burin.test.every-input", "radius=0.15"};
/// Rises to infinity where the surface is upright.
inline const std::vector<const char*> raise_to = {"brush=org.burin.test.raise-to", "radius=0.15"};

}  // namespace burin::test
