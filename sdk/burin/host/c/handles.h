#pragma once
#include <burin/base/progress.h>
#include <burin/host/brush_library.h>
#include <burin/host/c/burin.h>
#include <burin/host/c/shown_values.h>
#include <burin/host/host_extensions.h>
#include <burin/host/session.h>
#include <burin/stroke/stabiliser.h>
#include <burin/stroke/stroke_settings.h>

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// What the pointers of C point to.
struct burin_library {
  std::shared_ptr<burin::BrushLibrary> brushes;
  std::vector<std::string> refused;  ///< lines of modules that were passed over
};

namespace burin::c {

/// What C needs to know of the open stroke besides what the session knows.
struct OpenStroke {
  explicit OpenStroke(const ReplaySettings& settings)
      : fields(settings.fields), closure(settings.closure), stabilising(settings.stabilising) {}

  PenFields fields;
  Closure closure;
  Stabilising stabilising;
  Stabiliser stabiliser{stabilising};
  double last_time = 0;      ///< of the samples so far
  bool has_samples = false;  ///< last_time is one's
  bool piece_begun = false;  ///< the current piece has a sample
  bool whole = true;         ///< no piece has ended yet
};

inline constexpr std::size_t attribute_count = 4;

}  // namespace burin::c

struct burin_session {
  burin_session(std::shared_ptr<burin::BrushLibrary> library, burin::Surface surface, burin_order numbers)
      : brushes(std::move(library)),
        session(std::move(surface), *brushes),
        order(session.surface(), numbers) {}

  /// Notes vertices of the surface that may have changed.
  void note(std::span<const burin::Index> vertices) {
    for (auto& values : shown)
      if (values) values->note(vertices, order);
  }

  /// Notes what the session's last call changed.
  void note_changed() { note(session.changed()); }

  std::shared_ptr<burin::BrushLibrary> brushes;
  burin::Session session;
  burin::c::VertexOrder order;
  burin::Progress progress;
  std::optional<burin::c::OpenStroke> stroke;
  /// [attribute - 1]; made with its first update
  std::array<std::optional<burin::c::ShownValues>, burin::c::attribute_count> shown;
  std::vector<burin::Index> chart_vertices;  ///< of burin_session_chart
  std::vector<burin_sample> snapped;         ///< of burin_session_snap
};

namespace burin::c {

/// Makes the library of burin_library_create(), with extensions for its plugins. Throws plugin::Error for
/// what the caller got wrong.
void create_library(const burin_library_options* options, std::unique_ptr<HostExtensions> extensions,
                    burin_library** library);

}  // namespace burin::c
