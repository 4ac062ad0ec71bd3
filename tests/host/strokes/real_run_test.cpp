// Tests the whole pipeline on real input: a cage refined to millions of triangles, a recorded pen, a
// photographed stamp.
#include <burin/host/replay.h>
#include <burin/ink/import_pen_file.h>
#include <burin/subdiv/refine.h>
#include <burin/surface/mesh_file.h>

#include "host/sessions.h"
#include "support/shared_data.h"

namespace burin {
namespace {

/// A view of the whole mesh from the front, a little from above.
Camera camera_on(const PolygonMesh& mesh) {
  Eigen::AlignedBox3f box;
  for (const Vec3f& position : mesh.positions) box.extend(position);
  return framing_camera(box.min().cast<double>(), box.max().cast<double>(), {0.3, -0.2, -1}, Vec3d::UnitY(),
                        1000, 800, 0.6);
}

Surface refined_to(const PolygonMesh& cage, std::size_t triangles) {
  const SubdivisionScheme scheme = natural_scheme(cage);
  return make_surface(refine(cage, scheme, level_for_triangles(cage, scheme, triangles)));
}

TEST(RealRun, DisplacesNothingOutsideTheChartsOfARecordedPen) {
  BURIN_SHARED_DATA_OR_SKIP(cage_file, "meshes/spot_control_mesh.obj");
  BURIN_SHARED_DATA_OR_SKIP(pen_file, "strokes/painting30sec.dat");
  BURIN_SHARED_DATA_OR_SKIP(stamp_file, "stamps/Rock035_height_1024_half_zip.exr");
  const PolygonMesh cage = read_mesh(cage_file);
  Surface surface = refined_to(cage, 3'000'000);
  const Recording recording =
      import_pen_file(pen_file, read_pen_file(pen_file), {}, camera_on(cage), surface).recording;
  Session session(std::move(surface), test::brushes());
  const std::vector<Vec3f> base(session.positions().begin(), session.positions().end());
  ASSERT_GE(session.surface().triangles.size(), 3'000'000u);

  GivenSettings overrides;
  overrides[&StrokeSettings::brush] = "org.burin.scales";
  overrides[&StrokeSettings::radius] = 0.03;
  overrides[&StrokeSettings::params] = {{"stamp", stamp_file.string()}};
  std::vector<bool> in_a_chart(base.size(), false);
  const ReplayObserver mark_charts{{}, [&](const Session& drawn) {
                                     for (const Index vertex : drawn.chart().vertex)
                                       in_a_chart[vertex] = true;
                                   }};
  const ReplayResult result = replay(session, recording, overrides, mark_charts);
  EXPECT_EQ(result.strokes, 30u);
  EXPECT_GT(result.samples_drawn, 500u);

  std::size_t displaced = 0;
  for (Index vertex = 0; vertex < base.size(); ++vertex) {
    const Vec3f &position = session.positions()[vertex], &normal = session.normals()[vertex];
    ASSERT_TRUE(position.allFinite() && normal.allFinite()) << vertex;
    if (position == base[vertex]) continue;
    ASSERT_TRUE(in_a_chart[vertex]) << vertex;
    ++displaced;
  }
  EXPECT_GT(displaced, 50'000u);

  while (session.undo()) continue;
  EXPECT_TRUE(std::ranges::equal(session.positions(), base));
}

}  // namespace
}  // namespace burin
