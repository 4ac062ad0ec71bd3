// Runs a case: draws its strokes several times on one session, with undo in between, and collects times,
// counters and memory. All repeats must give the same hash and the same counters.
#include "bench/run_case.h"

#include <burin/base/hash.h>
#include <burin/base/stopwatch.h>
#include <burin/base/text/quoted_word.h>
#include <burin/host/replay.h>
#include <burin/level_set/solid_mesh.h>
#include <burin/stroke/move_origin.h>
#include <fmt/format.h>

#include <numeric>

#include "bench/regression.h"
#include "bench/straight_stroke.h"
#include "input/name_file.h"
#include "input/radius_fit.h"
#include "input/stroke_input.h"
#include "input/suite_params.h"
#include "pictures/result_picture.h"
#include "replay/replay_pictures.h"
#include "report/report_folder.h"
#include "system/platform.h"

namespace burin {
namespace {

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

/// The rate count / seconds; 0 if no time passed.
double rate(double count, double seconds) { return seconds > 0 ? count / seconds : 0; }

std::size_t growth(std::size_t before, std::size_t after) { return after > before ? after - before : 0; }

template <class Vector>
std::uint64_t bytes(const Vector& items) {
  return items.size() * sizeof(typename Vector::value_type);
}

/// The memory of the surface's arrays, bytes.
std::uint64_t surface_bytes(const Surface& surface) {
  return bytes(surface.positions) + bytes(surface.normals) + bytes(surface.triangles) +
         bytes(surface.gauss_curvature) + bytes(surface.neighbours.offsets) +
         bytes(surface.neighbours.items) + bytes(surface.incident.offsets) + bytes(surface.incident.items) +
         bytes(surface.source_vertex);
}

double chart_seconds(const Calls& calls) {
  double seconds = 0;
  for (const EventCost& cost : calls.costs) seconds += cost.seconds[static_cast<std::size_t>(Stage::chart)];
  return seconds;
}

/// The results of one repeat.
struct Drawn {
  std::uint64_t hash = 0;
  std::map<std::string, std::uint64_t> counters;
  Calls events, ends;
  double seconds = 0;
};

void count(const std::vector<EventCost>& costs, std::map<std::string, std::uint64_t>& counters) {
  for (const EventCost& cost : costs) {
    counters["settled"] += cost.settled;
    counters["pushes"] += cost.pushes;
    counters["evaluated"] += cost.evaluated;
    counters["moved"] += cost.moved;
  }
}

void add(const ReplayResult& result, Drawn& drawn) {
  drawn.hash = result.hash;
  drawn.events.append({result.latencies, result.costs});
  drawn.ends.append({result.end_latencies, result.end_costs});
  drawn.counters["events"] += result.samples_drawn;
  drawn.counters["off_surface"] += result.samples_off_surface;
  drawn.counters["pieces"] += result.pieces;
  drawn.counters["changed"] += result.vertices_changed;
  count(result.costs, drawn.counters);
  count(result.end_costs, drawn.counters);
  drawn.seconds = sum(drawn.events.seconds) + sum(drawn.ends.seconds);
}

/// Runs one case on one session.
class CaseRunner {
 public:
  CaseRunner(const std::string& path, const BenchCase& bench_case, const BrushLibrary& brushes,
             const Progress& progress)
      : case_(bench_case),
        settings_(settings_of_suite(path, bench_case.settings, brushes)),
        progress_(progress) {
    result_.name = bench_case.name;
    result_.mesh = bench_case.mesh.path;
    result_.axis = bench_case.axis;
    load(brushes);
    for (const std::string& file : bench_case.strokes) {
      recordings_.push_back(read_whole_strokes(file));
      move_origin(recordings_.back(), origin_);
    }
    if (bench_case.radius_edges)
      settings_[&StrokeSettings::radius] = *bench_case.radius_edges * mean_edge_length(session_->surface());
    if (bench_case.straight)
      recordings_.push_back(make_straight_stroke(session_->surface(), session_->picker(),
                                                 *bench_case.straight,
                                                 *settings_.find(&StrokeSettings::radius)));
  }

  CaseResult run(std::size_t repeat, const std::filesystem::path& picture);

 private:
  void load(const BrushLibrary& brushes);
  Drawn draw();
  void draw_picture(const std::filesystem::path& file);
  void undo_all();
  void take(const Drawn& drawn, std::size_t number);
  CaseResult finish();

  const BenchCase& case_;
  GivenSettings settings_;
  const Progress& progress_;
  Vec3d origin_ = Vec3d::Zero();  ///< origin to which positions are relative
  std::optional<Session> session_;
  std::vector<Recording> recordings_;
  StrokeExtent extent_;  ///< extent of the last repeat
  Calls events_, ends_, undos_;
  CaseResult result_;
};

void CaseRunner::load(const BrushLibrary& brushes) {
  const std::size_t memory_before = resident_memory();
  const Stopwatch watch;
  LoadedSurface loaded = load_surface(case_.mesh, progress_);
  origin_ = loaded.from.origin;
  settings_[&StrokeSettings::symmetry].centre -= origin_;
  session_.emplace(std::move(loaded.surface), brushes, merge_solid);
  session_->set_paint(std::move(loaded.paint));
  result_.load_seconds = watch.elapsed();
  result_.seconds_to_first_event = seconds_since_process_start();
  result_.memory.ready = growth(memory_before, resident_memory());
}

Drawn CaseRunner::draw() {
  Drawn drawn;
  extent_ = {};
  ReplayObserver observer{progress_, {}};
  observer.piece_ended = [&](const Session& session) {
    drawn.counters["region"] += session.chart().size();
    extent_.piece_ended(session);
  };
  for (std::size_t i = 0; i < recordings_.size(); ++i) {
    const auto draw_one = [&] { add(replay(*session_, recordings_[i], settings_, observer), drawn); };
    case_.straight ? draw_one() : with_file_context(case_.strokes[i], draw_one);
  }
  if (drawn.ends.seconds.empty()) throw Error("no stroke meets the surface");
  return drawn;
}

void CaseRunner::draw_picture(const std::filesystem::path& file) {
  ViewOptions options;
  options.width = 480;
  options.height = 360;
  const Camera camera = replay_view(session_->surface(), extent_, recordings_, options);
  const Picture picture = draw_result(*session_, part_meshes(*session_), camera, progress_);
  make_report_folder(file.parent_path().string());
  write_png(file, picture);
  result_.picture = file;
}

void CaseRunner::undo_all() {
  while (true) {
    const Stopwatch watch;
    if (!session_->undo()) return;
    undos_.append({{watch.elapsed()}, {session_->cost()}});
  }
}

void CaseRunner::take(const Drawn& drawn, std::size_t number) {
  if (number == 0) {
    result_.hash = hash_text(drawn.hash);
    result_.counters = drawn.counters;
  } else if (result_.hash != hash_text(drawn.hash) || result_.counters != drawn.counters) {
    throw Regression(fmt::format("{}: repeat {} gave another result than the first", case_.name, number + 1));
  }
  events_.append(drawn.events);
  ends_.append(drawn.ends);
  result_.stroke_seconds.push_back(drawn.seconds);
}

CaseResult CaseRunner::run(std::size_t repeat, const std::filesystem::path& picture) {
  const std::size_t memory_ready = resident_memory();
  for (std::size_t number = 0; number < repeat; ++number) {
    take(draw(), number);
    if (number == 0) result_.memory.strokes = growth(memory_ready, resident_memory());
    result_.memory.peak = peak_memory();
    if (number + 1 == repeat && !picture.empty()) draw_picture(picture);
    undo_all();
  }
  return finish();
}

CaseResult CaseRunner::finish() {
  const Surface& surface = session_->surface();
  result_.counters["vertices"] = surface.vertex_count();
  result_.counters["triangles"] = surface.triangles.size();
  result_.counters["surface_bytes"] = surface_bytes(surface);
  result_.event = call_figures(events_);
  result_.end = call_figures(ends_);
  result_.undo = call_figures(undos_);
  result_.distribution = distribution(events_.seconds);
  const auto repeats = static_cast<double>(result_.stroke_seconds.size());
  result_.vertices_per_second = rate(repeats * result_.counter("changed"), sum(result_.stroke_seconds));
  result_.nodes_per_second =
      rate(repeats * result_.counter("settled"), chart_seconds(events_) + chart_seconds(ends_));
  return std::move(result_);
}

}  // namespace

CaseResult run_case(const std::string& path, const BenchCase& bench_case, std::size_t repeat,
                    const std::filesystem::path& picture, const BrushLibrary& brushes,
                    const Progress& progress) {
  return with_file_context(path, [&] {
    try {
      return CaseRunner(path, bench_case, brushes, progress).run(repeat, picture);
    } catch (const FileError&) {
      throw;
    } catch (const Error& error) {
      throw Error(fmt::format("case {}: {}", quoted_word(bench_case.name), error.what()));
    }
  });
}

}  // namespace burin
