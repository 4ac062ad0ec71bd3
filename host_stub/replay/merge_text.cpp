// Writes the reports of merges as JSON and as lines for people.
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

}  // namespace burin
