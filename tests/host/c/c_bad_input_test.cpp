// What callers get wrong: a status, a text, and nothing else.
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "c_host.h"

namespace burin::test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

/// A call that must fail with this status and text.
struct Mistake {
  std::string text;
  std::function<burin_status(burin_text*)> call;
  burin_status status = BURIN_INVALID_ARGUMENT;
};

void expect_refused(const std::vector<Mistake>& mistakes) {
  for (const Mistake& mistake : mistakes) {
    CText error;
    EXPECT_EQ(mistake.call(&error), mistake.status) << mistake.text;
    EXPECT_EQ(error.str(), mistake.text);
    EXPECT_EQ(mistake.call(nullptr), mistake.status) << "without a buffer";
    burin_text none{sizeof none, 0, nullptr};
    EXPECT_EQ(mistake.call(&none), mistake.status) << "without room";
  }
}

const TriangleMesh& mesh() {
  static const TriangleMesh made = plane(1, 0.1, 4);
  return made;
}

/// The refusal of a mesh in arrays that differ from the sound ones.
Mistake of_mesh(const std::string& text, const std::function<void(burin_mesh&)>& change,
                burin_status status = BURIN_INVALID_ARGUMENT) {
  return {text,
          [change](burin_text* error) {
            burin_mesh arrays = arrays_of(mesh());
            change(arrays);
            auto* session = reinterpret_cast<burin_session*>(&arrays);
            const burin_status made = IN_C(burin_session_create)(c_brushes(), &arrays, &session, error);
            EXPECT_EQ(session, reinterpret_cast<burin_session*>(&arrays)) << "is not touched";
            return made;
          },
          status};
}

TEST(CBadInput, OfMeshesIsNamed) {
  static TriangleMesh far = mesh(), beyond = mesh();
  far.positions[7].y() = nan;
  beyond.triangles[4][1] = 100000;
  static const std::vector<std::int64_t> negative = {0, 1, -1};
  static const std::vector<std::uint32_t> sizes = {3, 2};
  static const double huge[9] = {0, 0, 0, 1e300};
  const std::string count = std::to_string(mesh().positions.size());
  expect_refused({
      of_mesh("mesh is missing or too small", [](burin_mesh& m) { m.struct_size = 72; }),
      of_mesh("positions is missing", [](burin_mesh& m) { m.positions = nullptr; }),
      of_mesh("corners is missing", [](burin_mesh& m) { m.corners = nullptr; }),
      of_mesh("vertex 7 has a coordinate that is not finite",
              [](burin_mesh& m) { m.positions = far.positions.data(); }),
      of_mesh("vertex 1 has a coordinate that is not finite",
              [](burin_mesh& m) {
                m.positions = huge;
                m.position_type = BURIN_FLOAT64;
                m.vertex_count = 3;
              }),
      of_mesh("corner 13 of the corners is vertex 100000, but there are " + count,
              [](burin_mesh& m) { m.corners = beyond.triangles.data(); }),
      of_mesh("corner 2 of the corners is vertex 18446744073709551615, but there are " + count,
              [](burin_mesh& m) {
                m.corners = negative.data();
                m.corner_type = BURIN_UINT64;
                m.face_count = 1;
              }),
      of_mesh("position_type is neither BURIN_FLOAT32 nor BURIN_FLOAT64",
              [](burin_mesh& m) { m.position_type = BURIN_UINT32; }),
      of_mesh("corner_type is neither BURIN_UINT32 nor BURIN_UINT64",
              [](burin_mesh& m) { m.corner_type = 0; }),
      of_mesh("there are more than 2^32 - 1 vertices or faces",
              [](burin_mesh& m) { m.vertex_count = UINT64_C(1) << 33; }),
      of_mesh("faces want either face_size or face_sizes", [](burin_mesh& m) { m.face_size = 0; }),
      of_mesh("faces want either face_size or face_sizes",
              [](burin_mesh& m) { m.face_sizes = sizes.data(); }),
      of_mesh("faces have fewer than 3 corners", [](burin_mesh& m) { m.face_size = 2; }),
      of_mesh("face 1 has 2 corners",
              [](burin_mesh& m) {
                m.face_size = 0;
                m.face_sizes = sizes.data();
                m.face_count = 2;
              }),
      of_mesh("faces of several sizes have no stride",
              [](burin_mesh& m) {
                m.face_size = 0;
                m.face_sizes = sizes.data();
                m.face_stride = 8;
              }),
      of_mesh("there is no such order", [](burin_mesh& m) { m.order = 3; }),
      of_mesh(
          "no triangle has an area", [](burin_mesh& m) { m.face_count = 0; }, BURIN_ERROR),
      {"mesh is missing or too small",
       [](burin_text* error) {
         burin_session* session = nullptr;
         return IN_C(burin_session_create)(c_brushes(), nullptr, &session, error);
       }},
      {"library is missing",
       [](burin_text* error) {
         const burin_mesh arrays = arrays_of(mesh());
         burin_session* session = nullptr;
         return IN_C(burin_session_create)(nullptr, &arrays, &session, error);
       }},
      {"session is missing",
       [](burin_text* error) {
         const burin_mesh arrays = arrays_of(mesh());
         return IN_C(burin_session_create)(c_brushes(), &arrays, nullptr, error);
       }},
  });
}

class CBadCalls : public ::testing::Test {
 protected:
  /// The refusal of a stroke.
  Mistake of_settings(const std::string& text, std::vector<const char*> settings,
                      burin_status status = BURIN_INVALID_ARGUMENT) {
    settings.push_back(nullptr);
    return {text,
            [this, settings](burin_text* error) {
              auto stroke = sized<burin_stroke>();
              stroke.settings = settings.data();
              return IN_C(burin_session_begin)(session_, &stroke, error);
            },
            status};
  }
  /// The refusal of a sample that differs from a sound one.
  Mistake of_sample(const std::string& text, const std::function<void(burin_sample&)>& change) {
    return {text, [this, change](burin_text* error) {
              burin_sample samples[2] = {in_c(wave())[5], in_c(wave())[6]};
              change(samples[1]);
              return IN_C(burin_session_add)(session_, samples, 2, nullptr, error);
            }};
  }
  Mistake of_call(const std::string& text,
                  const std::function<burin_status(burin_session*, burin_text*)>& call,
                  burin_status status = BURIN_INVALID_ARGUMENT) {
    return {text, [this, call](burin_text* error) { return call(session_, error); }, status};
  }

  CSession session_{plane(1, 0.03, 4)};
};

TEST_F(CBadCalls, OfStrokesLeaveNothingOpen) {
  const std::uint64_t before = session_.hash();
  expect_refused({
      of_settings("settings lack the brush", {"radius=0.1"}),
      of_settings("settings lack the radius", {"brush=org.burin.groove"}),
      of_settings("settings: radius: must be a number above 0, not 0",
                  {"brush=org.burin.groove", "radius=0"}),
      of_settings("settings: radius: must be a number above 0, not 'wide'",
                  {"brush=org.burin.groove", "radius=wide"}),
      of_settings("settings: there is no setting 'radios'", {"radios=1"}),
      of_settings("settings: must be NAME=VALUE, not 'radius'", {"radius"}),
      of_settings("radius: is given twice", {"radius=1", "radius=2"}),
      of_settings("show_every: is for recordings; how many samples a call has decides when they are shown",
                  {"brush=org.burin.groove", "radius=0.1", "show_every=4"}),
      of_settings("refine: must be off, since burin_mesh.refines is not set",
                  {"brush=org.burin.groove", "radius=0.1", "refine=auto"}),
      of_settings("stabilise: the exponential filter wants BURIN_PEN_TIME",
                  {"brush=org.burin.groove", "radius=0.1", "stabilise=exponential:1"}),
      of_settings("org.burin.groove has no parameter 'colour'; there are: depth, width, taper, profile",
                  {"brush=org.burin.groove", "radius=0.1", "params=colour=1"}, BURIN_ERROR),
      {"stroke is missing or too small",
       [&](burin_text* error) { return IN_C(burin_session_begin)(session_, nullptr, error); }},
      {"settings is missing",
       [&](burin_text* error) {
         const auto stroke = sized<burin_stroke>();
         return IN_C(burin_session_begin)(session_, &stroke, error);
       }},
      {"sample 0: its position is not finite",
       [&](burin_text* error) {
         auto sample = sized<burin_sample>();
         sample.position[0] = nan;
         const char* const settings[] = {"brush=org.burin.groove", "radius=0.1", nullptr};
         auto stroke = sized<burin_stroke>();
         stroke.settings = settings;
         stroke.path = &sample;
         stroke.path_count = 1;
         return IN_C(burin_session_begin)(session_, &stroke, error);
       }},
      {"session is missing",
       [](burin_text* error) { return IN_C(burin_session_begin)(nullptr, nullptr, error); }},
      of_call("no stroke is open",
              [](burin_session* s, burin_text* error) { return IN_C(burin_session_end)(s, error); }),
      of_sample("no stroke is open", [](burin_sample&) {}),
      of_call(
          "there is no stroke to undo",
          [](burin_session* s, burin_text* error) { return IN_C(burin_session_undo)(s, error); },
          BURIN_NOT_FOUND),
      of_call(
          "there is no stroke to make again",
          [](burin_session* s, burin_text* error) { return IN_C(burin_session_redo)(s, error); },
          BURIN_NOT_FOUND),
      of_call("path is missing",
              [](burin_session* s, burin_text* error) {
                return IN_C(burin_session_replay)(s, nullptr, nullptr, error);
              }),
  });
  EXPECT_EQ(session_.try_begin({"brush=org.burin.none", "radius=0.1"}), BURIN_NOT_FOUND);
  EXPECT_EQ(session_.error.str().find("no brush 'org.burin.none'; there are: "), 0u);
  EXPECT_EQ(session_.info().stroke_open, 0u);
  EXPECT_EQ(session_.hash(), before);
}

TEST_F(CBadCalls, WithinAStrokeLeaveItOpen) {
  CSession undisturbed(plane(1, 0.03, 4));
  const std::vector<burin_sample> samples = in_c(wave());
  const auto first = std::vector<burin_sample>(samples.begin(), samples.begin() + 5);
  for (CSession* session : {&session_, &undisturbed}) {
    session->begin({"brush=org.burin.groove", "radius=0.15"},
                   BURIN_PEN_TIME | BURIN_PEN_PRESSURE | BURIN_PEN_TILT);
    session->add(first);
    session->update(BURIN_POSITIONS);
  }
  expect_refused({
      of_sample("sample 1: its position is not finite", [](burin_sample& s) { s.position[1] = nan; }),
      of_sample("sample 1: its direction is not finite", [](burin_sample& s) { s.direction[1] = 1e300; }),
      of_sample("sample 1: its time falls", [](burin_sample& s) { s.time = 0; }),
      of_sample("sample 1: its time falls", [](burin_sample& s) { s.time = nan; }),
      of_sample("sample 1: its pressure is not from 0 to 1", [](burin_sample& s) { s.pressure = 1.5f; }),
      of_sample("sample 1: its tilt or twist is not finite", [](burin_sample& s) { s.tilt_x = nan; }),
      of_sample("a sample is missing or too small", [](burin_sample& s) { s.struct_size = 8; }),
      of_call("samples is missing",
              [](burin_session* s, burin_text* error) {
                return IN_C(burin_session_add)(s, nullptr, 1, nullptr, error);
              }),
      of_settings("a stroke is open", {"brush=org.burin.groove", "radius=0.1"}),
      of_call("a stroke is open",
              [](burin_session* s, burin_text* error) { return IN_C(burin_session_undo)(s, error); }),
      of_call("a stroke is open",
              [](burin_session* s, burin_text* error) { return IN_C(burin_session_redo)(s, error); }),
      of_call("a stroke is open",
              [](burin_session* s, burin_text* error) {
                return IN_C(burin_session_replay)(s, "x", nullptr, error);
              }),
  });
  EXPECT_TRUE(session_.update(BURIN_POSITIONS).empty());
  for (CSession* session : {&session_, &undisturbed}) {
    session->add({samples.begin() + 5, samples.end()});
    session->end();
  }
  EXPECT_EQ(session_.hash(), undisturbed.hash());
}

TEST_F(CBadCalls, ThatReadWriteNothing) {
  static burin_range ranges[4];
  static std::uint64_t count = 77;
  static float values[4] = {5, 5, 5, 5};
  static std::uint32_t numbers[4] = {5, 5, 5, 5};
  static burin_range range{0, 1};
  const auto update = [](burin_attribute attribute, burin_range* to, std::uint64_t capacity) {
    return [=](burin_session* s, burin_text* error) {
      return IN_C(burin_session_update)(s, attribute, 0, to, capacity, &count, error);
    };
  };
  const auto read = [](burin_range what, burin_number type, void* data) {
    return [=](burin_session* s, burin_text* error) {
      auto target = sized<burin_target>();
      target.type = type;
      target.data = data;
      return IN_C(burin_session_read)(s, BURIN_POSITIONS, &what, &target, error);
    };
  };
  const std::uint64_t vertices = session_.info().vertex_count;
  expect_refused({
      of_call("there is no such attribute", update(5, ranges, 4)),
      of_call("there is no such attribute", update(0, ranges, 4)),
      of_call("ranges is missing", update(BURIN_POSITIONS, nullptr, 4)),
      of_call("there is room for no range", update(BURIN_POSITIONS, ranges, 0)),
      of_call("the range is not one of vertices", read({1, 0}, BURIN_FLOAT32, values)),
      of_call("the range is not one of vertices", read({0, vertices + 1}, BURIN_FLOAT32, values)),
      of_call("the type is neither BURIN_FLOAT32 nor BURIN_FLOAT64", read({0, 1}, BURIN_UINT32, values)),
      of_call("data is missing", read({0, 1}, BURIN_FLOAT32, nullptr)),
      of_call("target is missing or too small",
              [](burin_session* s, burin_text* error) {
                return IN_C(burin_session_read)(s, BURIN_POSITIONS, &range, nullptr, error);
              }),
      of_call("the map does not fit",
              [](burin_session* s, burin_text* error) {
                return IN_C(burin_session_read_map)(s, BURIN_MAP_CALLER_TO_SURFACE, numbers, 4, error);
              }),
      of_call("there is no such map",
              [](burin_session* s, burin_text* error) {
                return IN_C(burin_session_read_map)(s, 0, numbers, 1 << 20, error);
              }),
      of_call("the triangles do not fit",
              [](burin_session* s, burin_text* error) {
                return IN_C(burin_session_read_triangles)(s, numbers, 1, error);
              }),
      of_call(
          "hash is missing",
          [](burin_session* s, burin_text* error) { return IN_C(burin_session_hash)(s, nullptr, error); }),
      of_call("info is missing or too small",
              [](burin_session* s, burin_text* error) {
                return IN_C(burin_session_get_info)(s, nullptr, error);
              }),
  });
  const auto write = [](burin_attribute attribute, burin_range what, const std::vector<float>& from) {
    return [=](burin_session* s, burin_text* error) {
      auto source = sized<burin_source>();
      source.type = BURIN_FLOAT32;
      source.data = from.data();
      return IN_C(burin_session_write)(s, attribute, &what, &source, error);
    };
  };
  const std::uint64_t before = session_.hash();
  expect_refused({
      of_call("normals follow from positions", write(BURIN_NORMALS, {0, 1}, {0, 0, 1})),
      of_call("there is no such attribute", write(9, {0, 1}, {0, 0, 1})),
      of_call("a position is not finite", write(BURIN_POSITIONS, {0, 2}, {5, 5, 5, 0, nan, 0})),
      of_call("a value is not from 0 to 1", write(BURIN_MASKS, {0, 2}, {0, 1.5f})),
      of_call("a value is not from 0 to 1", write(BURIN_COLOURS, {0, 1}, {0, 0, nan, 0})),
      of_call("the range is not one of vertices", write(BURIN_MASKS, {vertices, vertices + 1}, {0})),
      of_call("source is missing or too small",
              [](burin_session* s, burin_text* error) {
                return IN_C(burin_session_write)(s, BURIN_MASKS, &range, nullptr, error);
              }),
  });
  EXPECT_EQ(session_.hash(), before);
  EXPECT_EQ(count, 77u);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(values[i], 5);
    EXPECT_EQ(numbers[i], 5u);
  }
  EXPECT_EQ(IN_C(burin_session_values)(session_, BURIN_POSITIONS), nullptr);
  EXPECT_EQ(IN_C(burin_session_values)(session_, 9), nullptr);
  EXPECT_EQ(IN_C(burin_session_values)(nullptr, BURIN_POSITIONS), nullptr);
  IN_C(burin_session_destroy)(nullptr);
  IN_C(burin_library_destroy)(nullptr);
}

TEST(CBadInput, OfStepsGroupsAndPatchesIsNamed) {
  CSession session(mesh());
  burin_session* const members[] = {session, nullptr};
  burin_step* step = nullptr;
  burin_group* group = nullptr;
  auto info = sized<burin_step_info>();
  auto patch = sized<burin_patch>();
  const burin_sample sample{};
  burin_mesh placed = arrays_of(mesh());
  const double identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  placed.transform = identity;
  burin_triangles* triangles = nullptr;
  expect_refused({
      {"session is missing", [&](burin_text* e) { return IN_C(burin_session_take_step)(nullptr, &step, e); }},
      {"step is missing", [&](burin_text* e) { return IN_C(burin_session_take_step)(session, nullptr, e); }},
      {"there is no stroke to undo",
       [&](burin_text* e) { return IN_C(burin_session_take_step)(session, &step, e); }, BURIN_NOT_FOUND},
      {"step is missing", [&](burin_text* e) { return IN_C(burin_session_apply_step)(session, nullptr, e); }},
      {"step is missing", [&](burin_text* e) { return IN_C(burin_step_get_info)(nullptr, &info, e); }},
      {"step is missing", [&](burin_text* e) { return IN_C(burin_step_save)(nullptr, &info, 8, e); }},
      {"bytes is missing", [&](burin_text* e) { return IN_C(burin_step_load)(nullptr, 0, &step, e); }},
      {"a saved step does not begin as one",
       [&](burin_text* e) { return IN_C(burin_step_load)("burin", 5, &step, e); }, BURIN_ERROR},
      {"session is missing", [&](burin_text* e) { return IN_C(burin_session_hide)(nullptr, nullptr, 0, e); }},
      {"patch is missing or too small",
       [&](burin_text* e) { return IN_C(burin_session_take_patch)(session, nullptr, e); }},
      {"session is missing",
       [&](burin_text* e) { return IN_C(burin_session_take_patch)(nullptr, &patch, e); }},
      {"a session is missing",
       [&](burin_text* e) { return IN_C(burin_group_create)(members, 2, &group, e); }},
      {"sessions is missing", [&](burin_text* e) { return IN_C(burin_group_create)(nullptr, 1, &group, e); }},
      {"group is missing", [&](burin_text* e) { return IN_C(burin_group_begin)(nullptr, nullptr, e); }},
      {"group is missing",
       [&](burin_text* e) { return IN_C(burin_group_add)(nullptr, &sample, 1, nullptr, e); }},
      {"group is missing", [&](burin_text* e) { return IN_C(burin_group_undo)(nullptr, e); }},
      {"transform, hidden and refines are for sessions",
       [&](burin_text* e) { return IN_C(burin_triangles_refine)(&placed, nullptr, &triangles, e); }},
      {"transform, hidden and refines are for sessions",
       [&](burin_text* e) { return IN_C(burin_mesh_write)("no.ply", &placed, nullptr, e); }},
  });
  EXPECT_EQ(step, nullptr);
  EXPECT_EQ(group, nullptr);
  EXPECT_EQ(triangles, nullptr);
  IN_C(burin_step_destroy)(nullptr);
  IN_C(burin_group_destroy)(nullptr);
}

}  // namespace
}  // namespace burin::test
