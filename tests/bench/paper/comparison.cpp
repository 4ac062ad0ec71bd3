#include "comparison.h"

#include <fmt/format.h>

#include "pictures.h"

namespace burin::paper {

constexpr int arap_iterations = 50;

Comparison::Comparison(const Subject& subject) : subject_(subject), exact_(measured_nodes(subject)) {
  add("stroke chart", chart_coordinates(subject));
}

void Comparison::add(const std::string& name, const Parameterization& places) {
  const DistanceError error = distance_error(subject_, exact_, places);
  pictures_.push_back({checkerboard_picture(subject_, places), name});
  rows_.push_back({name, fmt::format("{:.3f}", error.mean()), fmt::format("{:.2f}", error.max()),
                   fmt::format("{:.2f}", flipped(subject_.region, places))});
}

void Comparison::show(Page& page) const {
  page.pictures(pictures_);
  page.table({subject_.scene->name, "mean error of |d|, %", "max, %", "triangles turned over, %"}, rows_);
}

Parameterization dncp_of(const Subject& subject, std::span<const Constraint> constraints) {
  SolveTimes times;
  return dncp(flatten(subject.scene->surface, subject.region), subject.region, constraints, times);
}

Parameterization arap_of(const Subject& subject, std::span<const Constraint> constraints) {
  SolveTimes times;
  return arap(flatten(subject.scene->surface, subject.region), subject.region, constraints,
              dncp_of(subject, constraints), arap_iterations, times);
}

}  // namespace burin::paper
