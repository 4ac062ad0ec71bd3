// Brushes that move curves in ways that stock brushes do not. Each draws a ridge along the moved curve.
#include <burin/plugin/plugin.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using namespace burin::plugin;

constexpr BrushInfo info_of(const char* id, const char* name) {
  return {.id = id, .name = name, .vendor = "Burin", .version = "1.0.0"};
}

class Ridge : public Brush, public CurveFilter {
 public:
  void evaluate(const Batch& in, const Outputs& out) const override {
    const Floats t = in.t(), d = in.d(), radius = in.radius();
    for (std::size_t i = 0; i < in.size(); ++i) {
      const float rim = std::max(1 - in.stroke.distance(t[i], d[i]) / radius[i], 0.0f);
      out.up()[i] = 0.3f * radius[i] * smooth_step(rim);
    }
  }
};

/// Pulls every point towards the mean of the drawn points that are within half a radius behind and one
/// ahead.
class Smoothed : public Ridge {
 public:
  static constexpr BrushInfo info = info_of("org.burin.test.smoothed-curve", "Smoothed curve");

  explicit Smoothed(StrokeStart& start) : radius_(start.stroke.radius_max()) {}

  CurveReach reach() const noexcept override { return {radius_ / 2, radius_}; }

  void move(const CurvePoints& points, FloatsOut along, FloatsOut across) const override {
    const Floats t = points.t();
    const Vectors at = points.position(), normal = points.normal(), e1 = points.e1();
    for (std::size_t i = 0; i < points.size(); ++i) {
      float x = 0, y = 0, z = 0, count = 0;
      for (std::size_t k = 0; k < points.size(); ++k) {
        if (t[k] < t[i] - reach().behind || t[k] > t[i] + reach().ahead) continue;
        x += at.x[k] - at.x[i];
        y += at.y[k] - at.y[i];
        z += at.z[k] - at.z[i];
        ++count;
      }
      const float e2_x = normal.y[i] * e1.z[i] - normal.z[i] * e1.y[i];
      const float e2_y = normal.z[i] * e1.x[i] - normal.x[i] * e1.z[i];
      const float e2_z = normal.x[i] * e1.y[i] - normal.y[i] * e1.x[i];
      const float side = points.stroke.mirrored() ? -1.0f : 1.0f;
      along[i] = (x * e1.x[i] + y * e1.y[i] + z * e1.z[i]) / count;
      across[i] = side * (x * e2_x + y * e2_y + z * e2_z) / count;
    }
  }

 private:
  const double radius_;
};

/// One arch over the whole stroke, a tenth of it high: only the finished stroke tells.
class Arch : public Ridge {
 public:
  static constexpr BrushInfo info = info_of("org.burin.test.arch", "Arch");

  CurveReach reach() const noexcept override { return {0, std::numeric_limits<double>::infinity()}; }

  void move(const CurvePoints& points, FloatsOut, FloatsOut across) const override {
    if (!points.stroke.finished()) throw Error("moved before its end");
    const auto length = static_cast<float>(points.stroke.length());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const float s = points.t()[i] / length;
      across[i] = 0.4f * length * s * (1 - s);
    }
  }
};

class NoNumber : public Ridge {
 public:
  static constexpr BrushInfo info = info_of("org.burin.test.no-number", "No number");

  void move(const CurvePoints& points, FloatsOut along, FloatsOut) const override {
    along[points.size() - 1] = std::numeric_limits<float>::quiet_NaN();
  }
};

class NoReach : public Ridge {
 public:
  static constexpr BrushInfo info = info_of("org.burin.test.no-reach", "No reach");

  CurveReach reach() const noexcept override { return {0, -1}; }
  void move(const CurvePoints&, FloatsOut, FloatsOut) const override {}
};

class Refuses : public Ridge {
 public:
  static constexpr BrushInfo info = info_of("org.burin.test.refuses-curves", "Refuses curves");

  void move(const CurvePoints&, FloatsOut, FloatsOut) const override { throw Error("not this curve"); }
};

}  // namespace

BURIN_PLUGIN(Smoothed, Arch, NoNumber, NoReach, Refuses);
