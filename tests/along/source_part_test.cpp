#include <burin/along/source_part.h>
#include <burin/base/error.h>
#include <gtest/gtest.h>

#include "along/bent.h"

namespace burin {
namespace {

TEST(SourcePart, IsTurnedIntoTheFrameOfAStroke) {
  // Along x, up y: what is at z is to the right.
  const SourcePart plain(test::box(1, 2, 3), {});
  EXPECT_EQ(plain.box.min(), Vec3d(0, -3, 0));
  EXPECT_EQ(plain.box.max(), Vec3d(1, 0, 2));
  AlongSettings axes;
  axes.forward = -Vec3d::UnitZ();
  const SourcePart turned(test::box(1, 2, 3), axes);
  EXPECT_EQ(turned.box.min(), Vec3d(-3, -1, 0));
  EXPECT_EQ(turned.box.max(), Vec3d(0, 0, 2));
  EXPECT_EQ(turned.length(), 3);
  EXPECT_EQ(turned.share({-3, 0, 0}), 0);
  EXPECT_EQ(turned.share({0, 0, 0}), 1);
}

TEST(SourcePart, KeepsTrianglesAndTextureCoordinates) {
  const SourcePart part(test::pipe(1, 1, 1), {});
  EXPECT_EQ(part.triangles.size(), 8u);
  EXPECT_EQ(part.triangle_uv.size(), 8u);
}

TEST(SourcePart, RefusesWhatCannotBeBent) {
  EXPECT_THROW(SourcePart(PolygonMesh(), {}), Error);
  EXPECT_THROW(SourcePart(test::box(0, 1, 1), {}), Error);
}

}  // namespace
}  // namespace burin
