// Writes the reports of merges and refinements as JSON and as lines for people.
#include "replay/merge_text.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace burin {

namespace {

/// The seconds of the steps, in their order.
Json seconds_json(const MergeReport& merge) {
  return {{"solid", merge.solid_seconds},     {"distances", merge.seconds.distances},
          {"contour", merge.seconds.contour}, {"join", merge.seconds.join},
          {"remesh", merge.seconds.remesh},   {"rebuild", merge.rebuild_seconds}};
}

}  // namespace

Json merges_json(std::span<const MergeReport> merges) {
  Json all = Json::array();
  for (const MergeReport& merge : merges)
    all.push_back({{"voxel", merge.voxel},
                   {"voxels", merge.voxels},
                   {"bytes", merge.bytes},
                   {"triangles_removed", merge.triangles_removed},
                   {"triangles_added", merge.triangles_added},
                   {"euler_before", merge.euler_before},
                   {"euler_after", merge.euler_after},
                   {"least_angle", merge.least_angle},
                   {"seconds", seconds_json(merge)}});
  return all;
}

std::string merges_text(std::span<const MergeReport> merges) {
  std::string text;
  for (const MergeReport& merge : merges)
    text += fmt::format(
        "merged          {} triangles in place of {}, in voxels of {:.3g}; Euler characteristic {}, before "
        "{}\n",
        merge.triangles_added, merge.triangles_removed, merge.voxel, merge.euler_after, merge.euler_before);
  return text;
}

Json refinements_json(std::span<const RefineReport> refinements) {
  Json all = Json::array();
  for (const RefineReport& refined : refinements)
    all.push_back({{"edge", refined.edge},
                   {"triangles_removed", refined.triangles_removed},
                   {"triangles_added", refined.triangles_added},
                   {"vertices_added", refined.vertices_added},
                   {"vertices_removed", refined.vertices_removed},
                   {"seconds",
                    {{"split", refined.split_seconds},
                     {"collapse", refined.collapse_seconds},
                     {"rebuild", refined.rebuild_seconds}}}});
  return all;
}

std::string refinements_text(std::span<const RefineReport> refinements) {
  std::string text;
  for (const RefineReport& refined : refinements)
    text +=
        fmt::format("refined         {} triangles in place of {}, with edges of about {:.3g}, in {:.3f} s\n",
                    refined.triangles_added, refined.triangles_removed, refined.edge,
                    refined.split_seconds + refined.collapse_seconds + refined.rebuild_seconds);
  return text;
}

}  // namespace burin
