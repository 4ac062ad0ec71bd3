#include <burin/base/error.h>
#include <burin/stroke/camera.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

namespace burin {
namespace {

Vec3d random_vector(std::mt19937& random) {
  std::uniform_real_distribution<double> number(-1, 1);
  return {number(random), number(random), number(random)};
}

/// Pixel of a position, straight from the definition in camera.h.
Eigen::Vector2d project(const Camera& camera, const Vec3d& position) {
  const Eigen::Vector4d clip = camera.projection * camera.view * position.homogeneous();
  const Eigen::Vector2d ndc = clip.head<2>() / clip.w();
  return {(ndc.x() + 1) / 2 * camera.width, (1 - ndc.y()) / 2 * camera.height};
}

Camera random_view(std::mt19937& random) {
  Eigen::Isometry3d view = Eigen::Isometry3d::Identity();
  view.translate(Vec3d(0, 0, -5));
  view.rotate(Eigen::AngleAxisd(3 * random_vector(random).x(), random_vector(random).normalized()));
  Camera camera;
  camera.view = view.matrix();
  camera.width = 800;
  camera.height = 600;
  return camera;
}

void expect_rays_project_back(const Camera& camera, std::mt19937& random) {
  std::uniform_real_distribution<double> x(0, camera.width), y(0, camera.height), along(0.1, 5);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector2d pixel(x(random), y(random));
    const Ray ray = pixel_ray(camera, pixel.x(), pixel.y());
    const Vec3d position = ray.origin.cast<double>() + along(random) * ray.direction.cast<double>();
    EXPECT_LT((project(camera, position) - pixel).norm(), 2e-3) << pixel.transpose();
    EXPECT_NEAR(ray.direction.norm(), 1, 1e-6);
    const Vec3d eye = (camera.view * position.homogeneous()).head<3>();
    EXPECT_LT(eye.z(), (camera.view * ray.origin.cast<double>().homogeneous()).z())
        << "not away from the eye";
  }
}

TEST(PixelRay, ProjectsBackInPerspective) {
  std::mt19937 random(7);
  for (int i = 0; i < 10; ++i) {
    Camera camera = random_view(random);
    camera.projection << 1.5, 0, 0.1, 0, 0, 2, -0.2, 0, 0, 0, -1.02, -0.202, 0, 0, -1, 0;
    expect_rays_project_back(camera, random);
  }
}

TEST(PixelRay, ProjectsBackWithAFarPlaneAtInfinity) {
  std::mt19937 random(8);
  Camera camera = random_view(random);
  camera.projection << 1.5, 0, 0, 0, 0, 2, 0, 0, 0, 0, -1, -0.2, 0, 0, -1, 0;
  expect_rays_project_back(camera, random);
}

TEST(PixelRay, IsParallelInOrthographicViews) {
  std::mt19937 random(9);
  Camera camera = random_view(random);
  camera.projection.diagonal() << 0.5, 0.7, -0.1, 1;
  camera.projection(2, 3) = -1.2;
  expect_rays_project_back(camera, random);
  const Ray left = pixel_ray(camera, 0, 300), right = pixel_ray(camera, 800, 20);
  EXPECT_LT((left.direction - right.direction).norm(), 1e-6);
  EXPECT_GT((left.origin - right.origin).norm(), 1);
}

TEST(PixelRay, CountsPixelsFromTheTopLeft) {
  Camera camera;
  camera.projection.diagonal() << 1, 1, -1, 1;
  camera.width = 4;
  camera.height = 2;
  const Ray ray = pixel_ray(camera, 0.5, 0.5);
  EXPECT_EQ(ray.origin, Vec3f(-0.75f, 0.5f, 1));
  EXPECT_EQ(ray.direction, Vec3f(0, 0, -1));
}

/// Corners of the box in normalised device coordinates, one a column.
Eigen::Matrix<double, 3, 8> corners_seen(const Camera& camera, const Vec3d& low, const Vec3d& high) {
  Eigen::Matrix<double, 3, 8> seen;
  for (int i = 0; i < 8; ++i) {
    const Vec3d corner((i & 1 ? high : low).x(), (i & 2 ? high : low).y(), (i & 4 ? high : low).z());
    const Eigen::Vector4d clip = camera.projection * camera.view * corner.homogeneous();
    EXPECT_GT(clip.w(), 0);
    seen.col(i) = clip.head<3>() / clip.w();
  }
  return seen;
}

TEST(FramingCamera, ShowsAllOfTheBoxAndFillsTheFrame) {
  std::mt19937 random(10);
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    const Vec3d middle = 10 * random_vector(random), half = random_vector(random).cwiseAbs();
    const Vec3d direction = random_vector(random);
    const int width = 100 + i * 5;
    const Camera camera =
        framing_camera(middle - half, middle + half, direction, Vec3d(0, 1, 0), width, 500, 0.3 + i / 100.0);
    const auto seen = corners_seen(camera, middle - half, middle + half);
    EXPECT_LE(seen.cwiseAbs().maxCoeff(), 1);
    EXPECT_GT(seen.topRows<2>().cwiseAbs().maxCoeff(), 0.6);
    EXPECT_LT((project(camera, middle) - Eigen::Vector2d(width / 2.0, 250)).norm(), 1e-6);
    const Ray ray = pixel_ray(camera, width / 2.0, 250);
    EXPECT_LT((ray.direction.cast<double>() - direction.normalized()).norm(), 1e-5);
    const Eigen::Vector2d above = project(camera, middle + Vec3d(0, 0.01, 0));
    EXPECT_LT(above.y(), 250);
    EXPECT_NEAR(above.x(), width / 2.0, 1e-6);
  }
}

TEST(FramingCamera, HasTheFieldOfViewAndSquarePixels) {
  const Camera camera =
      framing_camera(Vec3d(-1, -2, -3), Vec3d(1, 2, 3), Vec3d(1, 2, -3), Vec3d(0, 1, 0), 900, 300, 0.7);
  const Ray top = pixel_ray(camera, 450, 0), bottom = pixel_ray(camera, 450, 300);
  EXPECT_NEAR(std::acos(top.direction.dot(bottom.direction)), 0.7, 1e-5);
  const Ray left = pixel_ray(camera, 300, 150), right = pixel_ray(camera, 600, 150);
  EXPECT_NEAR(std::acos(left.direction.dot(right.direction)), 0.7, 1e-5);
}

TEST(FramingCamera, CopesWithABoxWithoutExtentAndUpAlongTheView) {
  const Vec3d place(1, 2, 3);
  const Camera camera = framing_camera(place, place, Vec3d(0, -1, 0), Vec3d(0, 1, 0), 640, 480, 1);
  EXPECT_TRUE(camera.view.allFinite());
  EXPECT_LE(corners_seen(camera, place, place).cwiseAbs().maxCoeff(), 1);
}

TEST(FramingCamera, RefusesWhatHasNoExtent) {
  const Vec3d low(0, 0, 0), high(1, 1, 1), up(0, 1, 0), front(0, 0, -1);
  EXPECT_THROW(framing_camera(high, low, front, up, 10, 10, 1), ContractError);
  EXPECT_THROW(framing_camera(low, high, low, up, 10, 10, 1), ContractError);
  EXPECT_THROW(framing_camera(low, high, front, up, 0, 10, 1), ContractError);
  EXPECT_THROW(framing_camera(low, high, front, up, 10, 10, 4), ContractError);
  EXPECT_THROW(framing_camera(low, high, front, up, 10, 10, std::nan("")), ContractError);
}

}  // namespace
}  // namespace burin
