// Renders a surface by ray casting: each of four samples per pixel casts a primary ray, a shadow ray to an
// area light and six rays for ambient occlusion. Rows are computed on all threads; noise depends on the pixel
// alone.
#include "pictures/render.h"

#include <burin/base/parallel.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <numbers>

#include <burin/base/srgb.h>
#include <burin/surface/files/over_clay.h>
#include <burin/surface/geometry/area_vector.h>

namespace burin {
namespace {

constexpr int grid = 2;  // samples per pixel in each direction
constexpr int samples = grid * grid;
constexpr int sky_rays = 6;  // per sample
constexpr float golden = 0.618034f;

struct Hit {
  SurfacePoint point;
  Vec3f normal;       // smooth, towards the eye
  Vec3f flat_normal;  // normal of the triangle, towards the eye
  Vec3f to_eye;
  // Height of the picture at the distance of the hit, object units; the scale for offsets.
  float frame_height = 0;
};

/// Two numbers in 0..1 that differ between close pixels: interleaved gradient noise [Jimenez 2014].
Vec2f pixel_noise(int x, int y) {
  const auto noise = [](float a, float b) {
    const float inner = 0.06711056f * a + 0.00583715f * b;
    const float outer = 52.9829189f * (inner - std::floor(inner));
    return outer - std::floor(outer);
  };
  const auto column = static_cast<float>(x), row = static_cast<float>(y);
  return {noise(column, row), noise(column + 47.0f, row + 17.0f)};
}

/// The cosine-weighted direction around `normal` with this index among all sky rays of a pixel.
Vec3f sky_direction(const Vec3f& normal, int index, const Vec2f& noise) {
  const float share = (static_cast<float>(index) + noise.x()) / static_cast<float>(samples * sky_rays);
  const float angle = 2 * std::numbers::pi_v<float> * (static_cast<float>(index) * golden + noise.y());
  const float radius = std::sqrt(share);
  const Vec3f side = normal.unitOrthogonal();
  return (radius * std::cos(angle) * side + radius * std::sin(angle) * normal.cross(side) +
          std::sqrt(std::max(0.0f, 1 - share)) * normal)
      .normalized();
}

struct SkyLight {
  Vec3f colour = Vec3f::Zero();
  float open = 0;  // share of the sky that is not occluded nearby
};

class Painter {
 public:
  Painter(const Surface& surface, const Picker& picker, const Camera& camera, const Albedo& albedo);
  void paint_row(int y, std::uint8_t* rgb) const;

 private:
  Vec3f corner_normal(Index vertex, const Vec3f& flat_normal) const;
  std::optional<Hit> hit(const Ray& ray) const;
  Vec3f radiance(const Hit& hit, int sample, const Vec2f& noise) const;
  SkyLight sky_light(const Hit& hit, int sample, const Vec2f& noise) const;
  Vec3f sky(const Vec3f& direction) const;
  Vec3f to_key_light(int sample, const Vec2f& noise) const;
  bool in_shadow(const Hit& hit, const Vec3f& to_light) const;
  Vec3f background(int y) const;
  Vec3f from_camera(float right, float up, float towards_eye) const;

  const Surface& surface_;
  const Picker& picker_;
  const Camera& camera_;
  const Albedo& albedo_;
  Eigen::Matrix3f to_world_;
  Vec3f key_, fill_, rim_, up_;
};

Painter::Painter(const Surface& surface, const Picker& picker, const Camera& camera, const Albedo& albedo)
    : surface_(surface),
      picker_(picker),
      camera_(camera),
      albedo_(albedo),
      to_world_(camera.view.topLeftCorner<3, 3>().cast<float>().transpose()),
      key_(from_camera(-0.6f, 0.62f, 0.52f)),
      fill_(from_camera(0.8f, 0.05f, 0.55f)),
      rim_(from_camera(0.3f, 0.6f, -0.7f)),
      up_(from_camera(0, 1, 0.25f)) {}

Vec3f Painter::from_camera(float right, float up, float towards_eye) const {
  return (to_world_ * Vec3f(right, up, towards_eye)).normalized();
}

/// That of the vertex, or the mean of the triangles around it that do not lie beyond a crease.
Vec3f Painter::corner_normal(Index vertex, const Vec3f& flat_normal) const {
  constexpr float crease = 0.75f, smooth = 0.99f;  // cosines
  const Vec3f& normal = surface_.normals[vertex];
  if (normal.dot(flat_normal) > smooth) return normal;
  bool is_whole = true;
  Vec3f sum = Vec3f::Zero();
  for (const Index triangle : surface_.incident[vertex]) {
    const Vec3f area = area_vector(surface_.positions, surface_.triangles[triangle]).cast<float>();
    const bool is_beyond = area.dot(flat_normal) < crease * area.norm();
    is_whole &= !is_beyond;
    if (!is_beyond) sum += area;
  }
  return is_whole || !(sum.squaredNorm() > 0) ? normal : sum.normalized();
}

std::optional<Hit> Painter::hit(const Ray& ray) const {
  const auto point = picker_.pick(ray);
  if (!point) return std::nullopt;
  const auto& [a, b, c] = point->corners;
  Hit hit;
  hit.point = *point;
  hit.to_eye = -ray.direction.normalized();
  hit.flat_normal = (surface_.positions[b] - surface_.positions[a])
                        .cross(surface_.positions[c] - surface_.positions[a])
                        .normalized();
  const Vec3f smooth = point->weights[0] * corner_normal(a, hit.flat_normal) +
                       point->weights[1] * corner_normal(b, hit.flat_normal) +
                       point->weights[2] * corner_normal(c, hit.flat_normal);
  hit.normal = smooth.squaredNorm() > 1e-12f ? smooth.normalized() : hit.flat_normal;
  if (hit.flat_normal.dot(hit.to_eye) < 0) {
    hit.flat_normal = -hit.flat_normal;
    hit.normal = -hit.normal;
  }
  const Eigen::Vector4d clip =
      camera_.projection * camera_.view * point->position.cast<double>().homogeneous();
  hit.frame_height = static_cast<float>(2 * clip.w() / camera_.projection(1, 1));
  return hit;
}

bool Painter::in_shadow(const Hit& hit, const Vec3f& to_light) const {
  const Vec3f origin = hit.point.position + 2e-4f * hit.frame_height * hit.flat_normal;
  return picker_.pick({origin, to_light}).has_value();
}

Vec3f Painter::sky(const Vec3f& direction) const {
  const float height = 0.5f + 0.5f * direction.dot(up_);
  return (1 - height) * Vec3f(0.34f, 0.31f, 0.29f) + height * Vec3f(0.86f, 0.93f, 1.0f);
}

/// Light from the sky; nearer blockers occlude more.
SkyLight Painter::sky_light(const Hit& hit, int sample, const Vec2f& noise) const {
  const float reach = 0.12f * hit.frame_height;
  const Vec3f origin = hit.point.position + 2e-4f * hit.frame_height * hit.flat_normal;
  SkyLight light;
  for (int ray = 0; ray < sky_rays; ++ray) {
    const Vec3f direction = sky_direction(hit.normal, sample + samples * ray, noise);
    const auto blocker = picker_.pick({origin, direction});
    const float distance = blocker ? (blocker->position - origin).norm() / reach : 1.0f;
    const float open = std::min(1.0f, distance);
    light.open += open / sky_rays;
    light.colour += (0.05f + 0.95f * open) / sky_rays * sky(direction);
  }
  return light;
}

/// The direction to a point of the key light, which is a disc; each sample of a pixel has its own point.
Vec3f Painter::to_key_light(int sample, const Vec2f& noise) const {
  const float angle = 2 * std::numbers::pi_v<float> * (noise.x() + static_cast<float>(sample) / samples);
  const float share = noise.y() + golden * static_cast<float>(sample);
  const float radius = 0.16f * std::sqrt(share - std::floor(share));
  const Vec3f side = key_.unitOrthogonal();
  return (key_ + radius * (std::cos(angle) * side + std::sin(angle) * key_.cross(side))).normalized();
}

Vec3f Painter::radiance(const Hit& hit, int sample, const Vec2f& noise) const {
  const Vec3f& n = hit.normal;
  const Vec3f to_key = to_key_light(sample, noise);
  const float key = n.dot(to_key) > 0 && !in_shadow(hit, to_key) ? n.dot(to_key) : 0.0f;
  const float fill = std::max(0.0f, n.dot(fill_));
  const float edge = 1 - std::max(0.0f, n.dot(hit.to_eye));
  const float rim = edge * edge * edge * std::max(0.0f, 0.3f + n.dot(rim_));
  const float gloss = std::pow(std::max(0.0f, n.dot((key_ + hit.to_eye).normalized())), 30.0f);
  const SkyLight from_sky = sky_light(hit, sample, noise);
  // Crevices dim the lamps too, which is not physical but makes relief visible.
  const float relief = 0.25f + 0.75f * from_sky.open * from_sky.open;
  const Vec3f lamps = key * Vec3f(1.25f, 1.17f, 1.05f) + fill * Vec3f(0.09f, 0.11f, 0.15f);
  return albedo_(hit.point).cwiseProduct(relief * lamps + 0.36f * from_sky.colour) +
         Vec3f::Constant(0.4f * rim + (key > 0 ? 0.12f * relief * gloss : 0.0f));
}

Vec3f Painter::background(int y) const {
  const float share = (static_cast<float>(y) + 0.5f) / static_cast<float>(camera_.height);
  return (1 - share) * Vec3f(0.20f, 0.21f, 0.23f) + share * Vec3f(0.46f, 0.46f, 0.46f);
}

void Painter::paint_row(int y, std::uint8_t* rgb) const {
  for (int x = 0; x < camera_.width; ++x) {
    const Vec2f noise = pixel_noise(x, y);
    Vec3f light = Vec3f::Zero();
    for (int sample = 0; sample < samples; ++sample) {
      const int i = sample % grid, j = sample / grid;
      const double column = x + (i + 0.5) / grid, row = y + (j + 0.5) / grid;
      const auto seen = hit(pixel_ray(camera_, column, row));
      light += seen ? radiance(*seen, sample, noise) : background(y);
    }
    for (int channel = 0; channel < 3; ++channel) {
      rgb[3 * x + channel] = to_srgb(light[channel] / samples);
    }
  }
}

}  // namespace

Vec3f clay(const SurfacePoint&) { return clay_colour; }

Picture render(const Surface& surface, const Picker& picker, const Camera& camera, const Albedo& albedo,
               const Progress& progress) {
  constexpr int rows_at_once = 32;
  const Painter painter(surface, picker, camera, albedo);
  Picture picture{camera.width, camera.height, {}};
  const auto row_size = static_cast<std::size_t>(camera.width) * 3;
  picture.rgb.resize(row_size * static_cast<std::size_t>(camera.height));
  for (int first = 0; first < camera.height; first += rows_at_once) {
    report(progress, "drawing", static_cast<double>(first) / camera.height);
    const int count = std::min(rows_at_once, camera.height - first);
    parallel_blocks(static_cast<std::size_t>(count), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t row = begin; row < end; ++row) {
        const std::size_t y = static_cast<std::size_t>(first) + row;
        painter.paint_row(static_cast<int>(y), picture.rgb.data() + y * row_size);
      }
    });
  }
  return picture;
}

}  // namespace burin
