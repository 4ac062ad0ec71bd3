// org.burin.stitches: sews rows of thread that comes out of one hole of the surface and enters the next.

#include <burin/plugin/plugin.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace {

using namespace burin::plugin;

class Stitches : public Brush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.stitches",
      .name = "Stitches",
      .vendor = "Burin",
      .version = "1.0.0",
      .help = "Sews rows of whole stitches, with holes and a slightly puckered surface.",
      .features = {"procedural"},
      .inputs = BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS,
      .outputs = BURIN_OUTPUT_DISPLACEMENT,
  };
  static constexpr ChoiceParam pattern{
      .id = "pattern",
      .name = "Pattern",
      .help = "Straight along the stroke, crosses, or zigzag.",
      .choices = {"straight", "cross", "zigzag"},
  };
  static constexpr IntParam rows{
      .id = "rows",
      .name = "Rows",
      .help = "Rows side by side; threads of narrow rows are thin.",
      .hard = {1, 16},
      .soft = {1, 4},
      .default_value = 1,
  };
  static constexpr FloatParam length{
      .id = "length",
      .name = "Length",
      .help = "From stitch to stitch.",
      .unit = BURIN_UNIT_RADIUS,
      .hard = {0.05f, 1000},
      .soft = {0.5f, 4},
      .default_value = 2,
  };
  static constexpr FloatParam thread{
      .id = "thread",
      .name = "Thread",
      .help = "Half the thickness of the thread.",
      .unit = BURIN_UNIT_RADIUS,
      .hard = {0.005f, 0.25f},
      .default_value = 0.16f,
      .dynamic = true,
  };
  static constexpr FloatParam pucker{
      .id = "pucker",
      .name = "Pucker",
      .help = "Height of the surface between the holes.",
      .unit = BURIN_UNIT_RADIUS,
      .hard = {-1, 1},
      .soft = {0, 0.5f},
      .default_value = 0.06f,
      .dynamic = true,
  };
  static constexpr auto params = param_list(pattern, rows, length, thread, pucker);

  explicit Stitches(StrokeStart& start)
      : stitch_(stitches[start.params[pattern].value()]),
        rows_(static_cast<float>(start.params[rows].value())),
        length_(start.params[length].value() * start.stroke.radius_max()) {
    start.end_influence = length_;
  }

  void evaluate(const Batch& in, const Outputs& out) const override {
    const Floats t = in.t(), d = in.d(), radius = in.radius();
    const Floats threads = in.params[thread], puckers = in.params[pucker];
    const FloatsOut up = out.up();
    for (std::size_t i = 0; i < in.size(); ++i) {
      const Tile tile = tile_at(in.stroke, t[i], d[i], radius[i]);
      if (!tile.whole) continue;
      const float x = std::min(in.stroke.distance(t[i], d[i]) / radius[i], 1.0f);
      const float between = 0.5f - 0.5f * math::cos(2 * std::numbers::pi_v<float> * tile.u / tile.length);
      const float cloth = puckers[i] * radius[i] * (1 - x * x) * (1 - x * x) * between;
      // This limit keeps the holes, whose radius is 1.4 times that of the thread, within their tile.
      const float thickest = std::min(0.085f * tile.length, 0.21f * tile.width);
      up[i] = cloth + sewn(tile, std::min(threads[i] * radius[i], thickest));
    }
  }

 private:
  struct Tile {
    float u, v;           // position from the tile's start and from the middle of its row, object units
    float length, width;  // length of the tile and half width of its row, object units
    bool whole;           // whether the stitch fits into the stroke
  };
  /// The thread from one hole to another: u in tiles, v in half rows. Its middle may cross over another
  /// thread.
  struct Segment {
    float u0, v0, u1, v1;
    bool crosses_over;
  };
  static constexpr Segment straight[] = {{.13f, 0, .87f, 0, false}};
  static constexpr Segment cross[] = {{.2f, -.7f, .8f, .7f, false}, {.2f, .7f, .8f, -.7f, true}};
  static constexpr Segment zigzag[] = {{.12f, -.7f, .4f, .7f, false}, {.6f, .7f, .88f, -.7f, false}};
  static constexpr std::span<const Segment> stitches[] = {straight, cross, zigzag};

  Tile tile_at(const Stroke& stroke, float t, float d, float radius) const {
    const bool dab = stroke.dab();
    const double period = dab ? std::min(length_, 1.4 * radius) : stroke.whole_period(length_);
    const double place = t / period + (dab ? 0.5 : 0), tile = std::floor(place);
    const bool whole =
        stroke.closed() || (tile >= 0 && (dab ? tile < 1 : (tile + 1) * period <= stroke.length()));
    const float half_row = 0.8f * radius / rows_;
    const float row = std::clamp(std::floor(0.5f * (d / half_row + rows_)), 0.0f, rows_ - 1);
    return {static_cast<float>((place - tile) * period), d - half_row * (2 * row + 1 - rows_),
            static_cast<float>(period), half_row, whole};
  }

  /// The height above the cloth: the thread, of half thickness r, or the depth of the holes.
  float sewn(const Tile& tile, float r) const {
    float holes = 0, highest = -10 * r;
    for (const Segment& s : stitch_) {
      const float u = tile.u - s.u0 * tile.length, v = tile.v - s.v0 * tile.width;
      const float way_u = (s.u1 - s.u0) * tile.length, way_v = (s.v1 - s.v0) * tile.width;
      const float way = math::hypot(way_u, way_v);
      const float along = std::clamp((u * way_u + v * way_v) / way, 0.0f, way),
                  to_hole = std::min(along, way - along);
      const float beside = math::hypot(u - along * way_u / way, v - along * way_v / way);
      const float hole = std::min(math::hypot(u, v), math::hypot(u - way_u, v - way_v));
      holes = std::max(holes, 1 - smooth_step(hole / (1.4f * r)));
      const float sunk = 1.6f * r * (1 - smooth_step(to_hole / (2.5f * r)));
      const float over = s.crosses_over ? r * smooth_step(2 - std::abs(along - way / 2) / (1.5f * r)) : 0;
      highest = std::max(highest, r * strand_profile(beside / r) - sunk + over);
    }
    return std::max(-2 * r * holes, highest);
  }

  const std::span<const Segment> stitch_;
  const float rows_;
  const double length_;  // length of a tile on an open stroke, object units
};

}  // namespace

BURIN_PLUGIN(Stitches);
