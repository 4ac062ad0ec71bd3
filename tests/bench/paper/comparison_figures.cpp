#include "comparison.h"
#include "drawings.h"
#include "figures.h"

namespace burin::paper {

void dncp_figure(Page& page, const Scenes& scenes) {
  page.heading("Figure 11: the chart and a conformal map");
  page.paragraph(
      "DNCP of the same region, the vertices of the triangles under the stroke fixed at their (t, d).");
  for (const Drawing& drawing : {gentle_s(), bends(), gentle_on_ewer()}) {
    const Scene* scene = scenes.find(drawing.scene);
    if (!scene) continue;
    const Subject subject = draw(*scene, drawing);
    Comparison comparison(subject);
    comparison.add("DNCP",
                   dncp_of(subject, vertices_near_stroke(subject.region, subject.chart, subject.curve)));
    comparison.show(page);
  }
}

void arap_figure(Page& page, const Scenes& scenes) {
  page.heading("Figure 12: the chart and an as-rigid-as-possible map");
  page.paragraph(
      "ARAP of the same region, from DNCP, with vertices near the stroke fixed at their (t, d), or points of "
      "the stroke inside triangles at (t, 0).");
  for (const Drawing& drawing : {bends(), gentle_on_ewer()}) {
    const Scene* scene = scenes.find(drawing.scene);
    if (!scene) continue;
    const Subject subject = draw(*scene, drawing);
    Comparison comparison(subject);
    comparison.add("ARAP, vertices fixed",
                   arap_of(subject, vertices_near_stroke(subject.region, subject.chart, subject.curve)));
    comparison.add("ARAP, points fixed", arap_of(subject, points_on_stroke(subject.region, subject.curve)));
    comparison.show(page);
  }
}

void hairpin_figure(Page& page, const Scenes& scenes) {
  page.heading("Figure 14: a turning radius smaller than the stroke's");
  const Drawing drawing = hairpin();
  const Subject subject = draw(*scenes.find(drawing.scene), drawing);
  Comparison comparison(subject);
  comparison.add("ARAP, vertices fixed",
                 arap_of(subject, vertices_near_stroke(subject.region, subject.chart, subject.curve)));
  comparison.show(page);
}

}  // namespace burin::paper
