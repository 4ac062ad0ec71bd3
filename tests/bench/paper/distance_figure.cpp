#include <fmt/format.h>

#include "drawings.h"
#include "figures.h"
#include "pictures.h"
#include "support/gentle_stroke.h"

namespace burin::paper {

void distance_figure(Page& page, const Scenes& scenes) {
  page.heading("Figure 10: error of |d| as the geodesic distance");
  page.paragraph(
      "Percent of the radius, against exact polyhedral geodesics, between the stroke's ends and away from "
      "the "
      "medial axis. Checkerboard: squares of a quarter of the radius. Error: white 0, red 2 % and more; "
      "clay: "
      "not measured.");
  std::vector<std::vector<std::string>> rows;
  for (const Drawing& drawing : {gentle_s(), bends(), sharp_bends()}) {
    const Scene* scene = scenes.find(drawing.scene);
    if (!scene) continue;
    const Subject subject = draw(*scene, drawing);
    const Parameterization places = chart_coordinates(subject);
    const DistanceError error = distance_error(subject, measured_nodes(subject), places);
    rows.push_back({fmt::format("{} ({})", drawing.name, drawing.scene),
                    fmt::format("{:.1f}", subject.radius / test::mean_edge(scene->surface)),
                    std::to_string(subject.region.triangles.size()), fmt::format("{:.3f}", error.mean()),
                    fmt::format("{:.2f}", error.max())});
    page.pictures({{checkerboard_picture(subject, places), drawing.name},
                   {error_picture(subject, error, 2), "error of " + drawing.name}});
  }
  page.table({"stroke", "edges a radius", "triangles", "mean, %", "max, %"}, rows);
}

}  // namespace burin::paper
