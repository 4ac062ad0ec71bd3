#pragma once
#include "support/error_of.h"
#include "support/shapes.h"

#include <burin/host/session.h>
#include <burin/level_set/solid_mesh.h>
#include <burin/services/stamp_services.h>
#include <burin/stroke/recording.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace burin::test {

inline const std::filesystem::path brushes_folder = BURIN_BRUSHES;
inline const std::filesystem::path test_brushes_folder = BURIN_TEST_BRUSHES;
inline const std::filesystem::path test_plugins_folder = BURIN_TEST_PLUGINS;

/// The stock brushes and those that tests draw with.
inline const BrushLibrary& brushes() {
  static const auto library = [] {
    auto loaded = std::make_unique<BrushLibrary>(nullptr, stamp_services(read_vdb));
    loaded->load_folder(brushes_folder);
    for (const char* brush : {"curve_filters.burin", "every_input.burin", "raise_to.burin"})
      loaded->load(test_brushes_folder / brush);
    loaded->load(test_plugins_folder / "absurd_brush.burin");
    loaded->load(test_plugins_folder / "nan_brush.burin");
    loaded->load(test_plugins_folder / "error_brush.burin");
    loaded->load(test_plugins_folder / "greedy_brush.burin");
    loaded->load(test_plugins_folder / "throwing_brush.burin");
    return loaded;
  }();
  return *library;
}

inline Session plane_session() { return Session(make_surface(shuffled(plane(1, 0.02, 4), 5)), brushes()); }
inline Session sphere_session() { return Session(make_surface(sphere(5, 0.2, 6)), brushes()); }

inline StrokeSettings settings(const std::string& brush, double radius = 0.15) {
  StrokeSettings settings;
  settings.brush = brush;
  settings.radius = radius;
  settings.fields = {.pressure = true, .tilt = true};
  return settings;
}

/// Samples of an S over the plane, with a pen that does something.
inline std::vector<Sample> wave(int count = 40) {
  std::vector<Sample> samples;
  for (int i = 0; i < count; ++i) {
    const double s = static_cast<double>(i) / (count - 1);
    Sample sample;
    sample.time = 0.5 * s * s + 0.1 * s;
    sample.position = Vec3d(1.4 * s - 0.7, 0.4 * std::sin(5 * s), 0);
    sample.pen = {.pressure = static_cast<float>(1 - s / 2), .tilt_x = static_cast<float>(s), .tilt_y = 0.1f};
    samples.push_back(sample);
  }
  return samples;
}

/// Samples as a mouse gives them.
inline std::vector<Sample> without_pen(std::vector<Sample> samples) {
  for (Sample& sample : samples) sample.pen = {};
  return samples;
}

/// The wave on the unit sphere.
inline std::vector<Sample> wave_on_sphere(int count = 40) {
  std::vector<Sample> samples = wave(count);
  for (Sample& sample : samples)
    sample.position = Vec3d(sample.position.x(), sample.position.y(), 0.8).normalized();
  return samples;
}

inline void add(Session& session, const std::vector<Sample>& samples) {
  for (const Sample& sample : samples) {
    const StrokeEvent event = session.add_sample(sample.position, sample.time, sample.pen);
    ASSERT_EQ(event.outcome, StrokeEvent::Outcome::drawn);
  }
}

inline void draw(Session& session, const StrokeSettings& settings, const std::vector<Sample>& samples) {
  session.begin_stroke(settings);
  add(session, samples);
  session.end_stroke();
}

/// Everything of a session that a failed or undone stroke must leave as it was.
struct Snapshot {
  explicit Snapshot(const Session& session)
      : positions(session.surface().positions),
        normals(session.surface().normals),
        shown_positions(session.positions().begin(), session.positions().end()),
        shown_normals(session.normals().begin(), session.normals().end()) {}
  bool operator==(const Snapshot&) const = default;

  std::vector<Vec3f> positions, normals, shown_positions, shown_normals;
};

}  // namespace burin::test
