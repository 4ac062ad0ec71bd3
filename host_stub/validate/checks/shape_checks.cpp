// Checks results that must follow the surface: rims, seams, moved, mirrored and scaled strokes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "validate/probe/stroke.h"

namespace burin::validate {
namespace {

using Brush = burin_brush_descriptor;

bool excepted(const Brush& brush, const char* feature) {
  const auto features = list_of(brush.features);
  return std::any_of(features.begin(), features.end(),
                     [&](const char* tag) { return std::strcmp(tag, feature) == 0; });
}

float moved(const Row& row) { return std::hypot(row[0], row[1], row[2]); }

void check_rim(const Subject& subject) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    const bool told = BURIN_HAS(&descriptor, Brush, rim_slope) && descriptor.rim_slope > 0;
    if (!told || std::isinf(descriptor.rim_slope)) throw Skipped("it does not state a rim_slope");
    ProbeBrush brush(plugin, descriptor, subject);
    ProbeStroke stroke(brush);
    for (const float gap : {1.0f, 0.75f, 0.6f, 0.5f, 0.33f, 0.25f, 0.1f, 0.03f, 0.01f, 0.001f, 0.0f}) {
      std::vector<float> t, d;
      for (int i = 0; i < 400; ++i) {
        const float angle = 0.0157f * static_cast<float>(i), out = 1 - gap;
        t.insert(t.end(), {0.025f * static_cast<float>(i), -out * std::abs(std::sin(angle)),
                           10 + out * std::abs(std::sin(angle))});
        d.insert(d.end(), {i % 2 ? out : -out, out * std::cos(angle), out * std::cos(angle)});
      }
      const auto rows = stroke.evaluate(nodes_at(t, d));
      for (std::size_t i = 0; i < rows.size(); ++i)
        require(
            moved(rows[i]) <= descriptor.rim_slope * gap + 1e-4f,
            fmt::format(
                "moves a node {} from the rim, at t {} and d {}, by {}: more than its rim_slope {} allows",
                gap, t[i], d[i], moved(rows[i]), descriptor.rim_slope));
    }
  });
}

void check_seam(const Subject& subject) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    ProbeBrush brush(plugin, descriptor, subject);
    ProbeStroke stroke(brush);
    stroke.context.flags = BURIN_STROKE_CLOSED | BURIN_STROKE_FINAL;
    std::vector<float> start, end, d;
    for (int i = -19; i < 20; ++i) {
      start.push_back(0);
      end.push_back(10);
      d.push_back(0.05f * static_cast<float>(i));
    }
    Nodes before = nodes_at(start, d), after = nodes_at(end, d);
    after.columns = before.columns;
    for (std::size_t i = 0; i < d.size(); ++i) after.t(i) = 10;
    const float step = distance(stroke.evaluate(before), stroke.evaluate(after));
    require(step <= 2e-3f,
            fmt::format("a closed stroke has a step of {} at its seam; a pattern must fit a whole number "
                        "of times along it, see whole_period()",
                        step));
  });
}

/// Compares the result with that on a surface that `change` makes, divided by `factor`. `where` is that in
/// words.
void compare(const Subject& subject, const char* exception, const char* where, float factor,
             const std::function<void(Nodes&, burin_stroke_context&)>& change) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    if (excepted(descriptor, exception)) throw Skipped(std::string("it is excepted by ") + exception);
    ProbeBrush brush(plugin, descriptor, subject);
    Nodes nodes = random_nodes(500, subject.seed);
    const auto plain = ProbeStroke(brush).evaluate(nodes);
    if (!brush.values.scale_lengths(factor)) throw Skipped("a length among its parameters cannot be scaled");
    burin_stroke_context context = stroke_context();
    change(nodes, context);
    ProbeStroke stroke(brush, context);
    auto changed = stroke.evaluate(nodes);
    for (Row& row : changed)
      for (std::size_t k = 0; k < 3; ++k) row[k] /= factor;
    // Rounding may move a node over an edge of a pattern; more than a few are a fault.
    std::size_t different = 0;
    for (std::size_t i = 0; i < plain.size(); ++i)
      for (std::size_t k = 0; k < 8; ++k)
        if (std::abs(plain[i][k] - changed[i][k]) > 1e-3f) {
          ++different;
          break;
        }
    require(different <= 5, fmt::format("{} {} of 500 nodes have another result", where, different));
  });
}

void check_scaled(const Subject& subject) {
  compare(subject, BURIN_FEATURE_FIXED_SCALE,
          "with surface and radius four times as large, lengths divided by four,", 4,
          [](Nodes& nodes, burin_stroke_context& context) {
            scale(nodes, 4);
            context.length *= 4;
            context.radius_min *= 4;
            context.radius_max *= 4;
            context.object_scale *= 4;
          });
}

void check_moved(const Subject& subject) {
  compare(subject, BURIN_FEATURE_FIXED_PLACE, "on a surface that is turned and moved", 1,
          [](Nodes& nodes, burin_stroke_context&) {
            // A turn about an oblique axis, exact in floats.
            constexpr std::array<float, 9> matrix = {0, 0, 1, 0.6f, 0.8f, 0, -0.8f, 0.6f, 0};
            constexpr std::array<float, 3> move = {3, -2, 5};
            turn(nodes, matrix, move);
          });
}

void check_mirrored(const Subject& subject) {
  compare(subject, BURIN_FEATURE_ONE_HANDED, "in the mirror image", 1,
          [](Nodes& nodes, burin_stroke_context& context) {
            constexpr std::array<float, 9> matrix = {1, 0, 0, 0, -1, 0, 0, 0, 1};
            constexpr std::array<float, 3> move{};
            turn(nodes, matrix, move);
            context.flags |= BURIN_STROKE_MIRRORED;
          });
}

constexpr Check shape_list[] = {
    {"shape.rim", 2, "brush.h: rim_slope",
     "Measures displacements from the rim to the middle and around both caps.", check_rim},
    {"shape.seam", 2, "stroke.h: on closed strokes t and t + length are one place",
     "Compares both sides of the seam of a closed stroke.", check_seam},
    {"shape.moved", 2, "brush.h: results follow the surface; BURIN_FEATURE_FIXED_PLACE",
     "Draws on a surface that is turned and moved.", check_moved},
    {"shape.mirrored", 2, "brush.h: results follow the surface; BURIN_FEATURE_ONE_HANDED",
     "Draws the mirror image of a stroke.", check_mirrored},
    {"shape.scaled", 2, "brush.h: results follow the surface; BURIN_FEATURE_FIXED_SCALE",
     "Draws on a surface four times as large.", check_scaled},
};

}  // namespace

std::span<const Check> shape_checks() { return shape_list; }

}  // namespace burin::validate
