#pragma once
#include <burin/base/error.h>
#include <burin/surface/picker.h>
#include <embree3/rtcore.h>

#include <limits>
#include <memory>

namespace burin {

struct ReleaseDevice {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseScene {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Device = std::unique_ptr<RTCDeviceTy, ReleaseDevice>;
using EmbreeScene = std::unique_ptr<RTCSceneTy, ReleaseScene>;

inline Device new_device() {
  Device device(rtcNewDevice(nullptr));
  if (!device) throw Error("Embree cannot start on this machine");
  return device;
}

/// An Embree query along the whole ray.
inline RTCRayHit whole_ray(const Ray& ray) {
  RTCRayHit query{};
  query.ray.org_x = ray.origin.x();
  query.ray.org_y = ray.origin.y();
  query.ray.org_z = ray.origin.z();
  query.ray.dir_x = ray.direction.x();
  query.ray.dir_y = ray.direction.y();
  query.ray.dir_z = ray.direction.z();
  query.ray.tfar = std::numeric_limits<float>::infinity();
  query.ray.mask = ~0u;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  return query;
}

}  // namespace burin
