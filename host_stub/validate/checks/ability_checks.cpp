// Checks passes, end_influence and what a brush offers besides evaluate.
#include <burin/abi/ext/bench_budget.h>
#include <burin/abi/ext/curve_filter.h>
#include <burin/abi/ext/state.h>
#include <burin/abi/ext/volume.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "validate/probe/straight_curve.h"
#include "validate/probe/stroke.h"

namespace burin::validate {
namespace {

using Brush = burin_brush_descriptor;

/// Calls `check` for each brush that offers this interface, with an open stroke.
template <class Interface, class Function>
void each_offering(const Subject& subject, const char* id, const Function& check) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    ProbeBrush brush(plugin, descriptor, subject);
    const auto* offered = brush.interface<Interface>(id);
    if (!offered) throw Skipped(fmt::format("it does not offer {}", id));
    check(brush, *offered);
  });
}

void check_plan(const Subject& subject) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    ProbeBrush brush(plugin, descriptor, subject);
    const ProbeStroke stroke(brush);
    require(stroke.plan.passes >= 1, "asks for no pass");
    require(stroke.plan.end_influence >= 0,
            fmt::format("asks for an end influence of {}", stroke.plan.end_influence));
  });
}

void check_passes(const Subject& subject) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    ProbeBrush brush(plugin, descriptor, subject);
    ProbeStroke stroke(brush);
    if (stroke.plan.passes < 2) throw Skipped("it asks for one pass");
    Nodes nodes = random_nodes(500, subject.seed);
    for (stroke.context.pass = 0; stroke.context.pass < stroke.plan.passes; ++stroke.context.pass) {
      const auto rows = stroke.evaluate(nodes);
      require_finite(rows, nodes);
      for (std::size_t i = 0; i < rows.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) nodes.of(BURIN_INPUT_DISPLACEMENT, k)[i] = rows[i][k];
    }
  });
}

/// Lets a stroke of this length grow and end, and looks at nodes from its start to t = `back`.
void let_grow(ProbeStroke& stroke, double length, double back, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<float> t, d;
  for (int i = 0; i < 2000; ++i) {
    t.push_back(static_cast<float>(-1 + (back + 1) * static_cast<double>(random() >> 11) * 0x1p-53));
    d.push_back(-0.7f + 1.4f * static_cast<float>(random() >> 40) * 0x1p-24f);
  }
  const Nodes nodes = nodes_at(t, d);
  stroke.context.length = length;
  stroke.context.flags = 0;
  const auto now = stroke.evaluate(nodes);
  for (const double growth : {0.01, 0.5, 3.0, 30.0})
    for (const std::uint64_t flags : {std::uint64_t{0}, BURIN_STROKE_FINAL}) {
      stroke.context.length = length + growth;
      stroke.context.flags = flags;
      const std::string other = difference(now, stroke.evaluate(nodes), nodes);
      require(other.empty(),
              fmt::format("what lies farther back than its end_influence {} changes as the stroke grows "
                          "from {} to {}{}: {}",
                          stroke.plan.end_influence, length, stroke.context.length, flags ? " and ends" : "",
                          other));
    }
}

void check_end_influence(const Subject& subject) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    ProbeBrush brush(plugin, descriptor, subject);
    ProbeStroke stroke(brush);
    // Of patterns along the stroke some end in the middle of a period.
    for (const double length : {10.0, 9.7, 9.3, 8.6}) {
      // A little farther back than declared, since t is a float.
      const double back = length - stroke.plan.end_influence - 1e-4;
      if (!(back > -1)) throw Skipped("its end influence is longer than the stroke");
      let_grow(stroke, length, back, subject.seed);
    }
  });
}

void check_end_distance(const Subject& subject) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    if (!(descriptor.inputs_read & BURIN_INPUT_END_DISTANCE)) throw Skipped("it does not read end_distance");
    ProbeBrush brush(plugin, descriptor, subject);
    ProbeStroke stroke(brush);
    if (stroke.plan.end_influence > 0) throw Skipped("it asks for an end_influence");
    Nodes nodes = random_nodes(1000, subject.seed);
    std::vector<float>& end_distance = nodes.of(BURIN_INPUT_END_DISTANCE);
    std::ranges::fill(end_distance, 0.0f);
    const auto at_the_end = stroke.evaluate(nodes);
    std::ranges::fill(end_distance, 1.0f);
    require(
        difference(at_the_end, stroke.evaluate(nodes), nodes).empty(),
        "reads end_distance, which is 0 everywhere, since it is at most end_influence, and that is 0: set "
        "end_influence to how far back it matters, as taper_influence() does");
  });
}

/// The saved state of a brush.
std::vector<char> saved(const ProbeBrush& brush, const burin_state& state) {
  std::uint64_t size = 0;
  const burin_status asked = state.save(&brush.abi(), nullptr, 0, &size, nullptr);
  require(asked == BURIN_INVALID_ARGUMENT || (asked == BURIN_OK && size == 0),
          "save without a buffer does not ask for one");
  std::vector<char> bytes(size);
  if (size == 0) return bytes;
  require(state.save(&brush.abi(), bytes.data(), size, &size, nullptr) == BURIN_OK, "save fails");
  require(size == bytes.size(), "save writes another number of bytes than it asked for");
  return bytes;
}

void check_state(const Subject& subject) {
  each_offering<burin_state>(subject, BURIN_EXT_STATE, [](ProbeBrush& brush, const burin_state& state) {
    const auto bytes = saved(brush, state);
    require(state.load(&brush.abi(), state.version, bytes.data(), bytes.size(), nullptr) == BURIN_OK,
            "does not load what it saved");
    require(saved(brush, state) == bytes, "saves other bytes than it loaded");
  });
}

/// Loads what is no state; if the brush refuses that, it stays as it was.
void load_damaged(const ProbeBrush& brush, const burin_state& state, const std::vector<char>& bytes) {
  const auto before = saved(brush, state);
  if (state.load(&brush.abi(), state.version, bytes.data(), bytes.size(), nullptr) == BURIN_OK) return;
  require(saved(brush, state) == before,
          fmt::format("a load of {} bytes that failed changes the brush", bytes.size()));
}

void check_damaged_state(const Subject& subject) {
  each_offering<burin_state>(subject, BURIN_EXT_STATE, [&](ProbeBrush& brush, const burin_state& state) {
    const auto bytes = saved(brush, state);
    for (std::size_t size = 0; size < bytes.size(); ++size)
      load_damaged(brush, state, {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)});
    std::vector<char> random(std::size_t{1} << 20);
    std::mt19937_64 generator(subject.seed);
    for (char& byte : random) byte = static_cast<char>(generator());
    load_damaged(brush, state, random);
  });
}

void check_state_versions(const Subject& subject) {
  each_offering<burin_state>(subject, BURIN_EXT_STATE, [](ProbeBrush& brush, const burin_state& state) {
    const auto bytes = saved(brush, state);
    require(state.load(&brush.abi(), state.version + 1000, bytes.data(), bytes.size(), nullptr) != BURIN_OK,
            "loads a state of a version that there never was");
  });
}

void check_older_states(const Subject& subject) {
  each_offering<burin_state>(subject, BURIN_EXT_STATE, [](ProbeBrush& brush, const burin_state& state) {
    constexpr std::uint32_t most = 100;
    for (std::uint32_t older = state.version - std::min(state.version, most); older < state.version;
         ++older) {
      const auto before = saved(brush, state);
      for (std::size_t size = 0; size <= before.size(); ++size) {
        const std::vector<char> part(before.begin(), before.begin() + static_cast<std::ptrdiff_t>(size));
        if (state.load(&brush.abi(), older, part.data(), size, nullptr) == BURIN_OK) break;
        require(saved(brush, state) == before,
                fmt::format("a load of version {} that failed changes the brush", older));
      }
    }
  });
}

void check_volume(const Subject& subject) {
  each_offering<burin_volume>(subject, BURIN_EXT_VOLUME, [&](ProbeBrush& brush, const burin_volume& volume) {
    ProbeStroke stroke(brush);
    const burin_stroke_context context = finished_context();
    burin_solid_plan plan{sizeof plan, 0, 0, 0, 0};
    require(volume.plan(&brush.abi(), stroke.self(), &context, &stroke.params(), &plan, nullptr) == BURIN_OK,
            "its plan fails");
    require(plan.h_min <= plan.h_max && plan.detail > 0, "its plan has no heights or no detail");
    const Nodes nodes = random_nodes(1000, subject.seed);
    std::vector<float> h(nodes.size()), distances(nodes.size());
    for (std::size_t i = 0; i < h.size(); ++i)
      h[i] = static_cast<float>(plan.h_min + (plan.h_max - plan.h_min) * static_cast<double>(i % 100) / 99);
    const burin_batch batch = batch_of(nodes, 0, nodes.size(), stroke.params());
    require(volume.distance(&brush.abi(), stroke.self(), &context, &batch, {h.data(), 1, 0},
                            {distances.data(), 1, 0}, nullptr) == BURIN_OK,
            "distance fails");
    for (const float distance : distances) require(!std::isnan(distance), "a distance is not a number");
  });
}

void check_curve_filter(const Subject& subject) {
  each_offering<burin_curve_filter>(
      subject, BURIN_EXT_CURVE_FILTER, [](ProbeBrush& brush, const burin_curve_filter& filter) {
        const ProbeStroke stroke(brush);
        burin_curve_reach reach{sizeof reach, 0, 0, 0};
        filter.reach(&brush.abi(), stroke.self(), &reach);
        require(reach.behind >= 0 && reach.ahead >= 0, "its reach is below 0");
        const auto moved = [&](std::size_t count, double length) {
          const auto made =
              offsets(brush, stroke, filter, StraightCurve(count).points(), length, "filter fails");
          for (std::size_t i = 0; i < count; ++i)
            require(std::hypot(made[i], made[count + i]) <= 100, "moves a point by more than 100 radii");
          return made;
        };
        const auto whole = moved(101, 10);
        require(whole == moved(101, 10), "moves the same curve in two ways");
        if (std::isinf(reach.ahead)) return;
        const auto longer = moved(131, 13);
        const auto kept = static_cast<std::size_t>(std::max(0.0, std::floor((10 - reach.ahead) / 0.1) - 1));
        for (std::size_t i = 0; i < std::min<std::size_t>(kept, 101); ++i)
          require(whole[i] == longer[i] && whole[101 + i] == longer[131 + i],
                  fmt::format("the point at t {:.1f} moves on as the curve grows beyond its reach",
                              0.1 * static_cast<double>(i)));
      });
}

constexpr Check ability_list[] = {
    {"ability.plan", 1, "brush.h: passes >= 1, end_influence >= 0", "Looks at the plan of a stroke.",
     check_plan},
    {"ability.passes", 2, "brush.h: evaluate runs over the whole stroke once per pass",
     "Evaluates all passes, each with the displacement of the one before.", check_passes},
    {"ability.end-influence", 2,
     "brush.h: end_influence, how far back from the end the result depends on length or FINAL",
     "Lets a stroke grow and end, and looks farther back than that.", check_end_influence},
    {"ability.end-distance", 2, "stroke.h: end_distance is at most end_influence",
     "Draws with other distances from the ends, if the brush asks for no end_influence.", check_end_distance},
    {"ability.state", 2, "ext/state.h: load restores what save wrote", "Saves, loads and saves a state.",
     check_state},
    {"ability.damaged-state", 3,
     "ext/state.h: load must treat bytes as untrusted; on failure the brush stays as it was",
     "Loads every beginning of a state, and 1 MB of random bytes.", check_damaged_state},
    {"ability.state-versions", 2, "ext/state.h: of other versions returns BURIN_UNSUPPORTED",
     "Loads a state of a version that there never was.", check_state_versions},
    {"ability.older-states", 3,
     "ext/state.h: load restores states of older versions or refuses them; on failure the brush stays as it "
     "was",
     "Loads beginnings of a state as states of each older version.", check_older_states},
    {"ability.volume", 2, "ext/volume.h: plan, distance", "Evaluates distances to the solid.", check_volume},
    {"ability.curve-filter", 2,
     "ext/curve_filter.h: the offset of a point within reach is the same whatever the part",
     "Moves a curve, and moves it again when it is longer.", check_curve_filter},
};

}  // namespace

std::span<const Check> ability_checks() { return ability_list; }

}  // namespace burin::validate
