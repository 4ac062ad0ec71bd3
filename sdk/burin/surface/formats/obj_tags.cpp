// Parses the subdivision tags of an OBJ file. They are stored in the mesh when it is complete, since a tag
// may stand before the vertices and faces that it names.
#include <burin/base/text/quoted_word.h>
#include <burin/surface/formats/obj_tags.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace burin {
namespace {

constexpr std::string_view known[] = {"crease", "corner", "hole", "interpolateboundary", "creasemethod"};

/// Removes the number before the next '/' from the front; returns nothing if there is none.
std::optional<std::size_t> take_count(std::string_view& counts) {
  const std::size_t end = std::min(counts.find('/'), counts.size());
  const auto count = whole_number(counts.substr(0, end));
  counts.remove_prefix(std::min(end + 1, counts.size()));
  if (!count || *count < 0) return std::nullopt;
  return static_cast<std::size_t>(*count);
}

std::string wrong_index(long long index, std::string_view what, std::size_t count) {
  if (index >= 0 && static_cast<std::size_t>(index) < count) return {};
  return fmt::format("names {} {}, counted from 0, of {}", what, index, count);
}

}  // namespace

std::string ObjTags::take(std::string_view line, std::size_t number) {
  Tag tag;
  tag.line = number;
  tag.name = next_word(line);
  if (std::ranges::find(known, tag.name) == std::end(known)) {
    ++unknown_;
    return {};
  }
  std::string_view counts = next_word(line);
  const std::string_view all = counts;
  std::size_t kinds[3];
  for (std::size_t& count : kinds) {
    const auto taken = take_count(counts);
    if (!taken)
      return fmt::format("{} is not the number of a tag's arguments, as in 2/1/0", quoted_word(all));
    count = *taken;
  }
  for (auto word = next_word(line); !word.empty(); word = next_word(line)) {
    const auto whole = whole_number(word);
    const auto real = real_number(word);
    if (tag.integers.size() < kinds[0]) {
      if (!whole) return fmt::format("{} is not an integer", quoted_word(word));
      tag.integers.push_back(*whole);
    } else if (tag.reals.size() < kinds[1]) {
      if (!real || !std::isfinite(*real)) return fmt::format("{} is not a real number", quoted_word(word));
      tag.reals.push_back(*real);
    } else {
      tag.words.emplace_back(word);
    }
  }
  if (tag.integers.size() != kinds[0] || tag.reals.size() != kinds[1] || tag.words.size() != kinds[2])
    return fmt::format("has not the arguments that {} announces", quoted_word(all));
  tags_.push_back(std::move(tag));
  return {};
}

namespace {

/// Sharpness values, one for all items or one per item, clamped to the range of non-negative floats.
class Sharpness {
 public:
  explicit Sharpness(const std::vector<double>& reals) : reals_(reals) {}

  /// Whether there are values for this many items.
  bool fits(std::size_t items) const { return reals_.size() == 1 || reals_.size() == items; }

  float of(std::size_t item) const {
    const double value = reals_.size() == 1 ? reals_[0] : reals_[item];
    return static_cast<float>(std::clamp(value, 0.0, double{std::numeric_limits<float>::max()}));
  }

 private:
  const std::vector<double>& reals_;
};

constexpr const char* sharpness_missing = "takes one sharpness for all, or one each";

std::string give_creases(const std::vector<long long>& vertices, const Sharpness& sharpness,
                         std::size_t vertex_count, PolygonMesh& mesh) {
  if (vertices.empty() || vertices.size() % 2 != 0) return "takes vertices by pairs";
  // OpenSubdiv's own shapes (regression/common/far_utils.h) may have a sharpness per vertex; that of a pair's
  // first vertex counts.
  const bool by_vertex = sharpness.fits(vertices.size());
  if (!by_vertex && !sharpness.fits(vertices.size() / 2)) return sharpness_missing;
  for (const long long vertex : vertices)
    if (std::string fault = wrong_index(vertex, "vertex", vertex_count); !fault.empty()) return fault;
  for (std::size_t i = 0; i < vertices.size(); i += 2)
    mesh.creases.push_back({static_cast<Index>(vertices[i]), static_cast<Index>(vertices[i + 1]),
                            sharpness.of(by_vertex ? i : i / 2)});
  return {};
}

std::string give_corners(const std::vector<long long>& vertices, const Sharpness& sharpness,
                         std::size_t vertex_count, PolygonMesh& mesh) {
  if (vertices.empty()) return "takes vertices";
  if (!sharpness.fits(vertices.size())) return sharpness_missing;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (std::string fault = wrong_index(vertices[i], "vertex", vertex_count); !fault.empty()) return fault;
    mesh.corners.push_back({static_cast<Index>(vertices[i]), sharpness.of(i)});
  }
  return {};
}

std::string give_holes(const std::vector<long long>& faces, PolygonMesh& mesh) {
  for (const long long face : faces) {
    if (std::string fault = wrong_index(face, "face", mesh.face_sizes.size()); !fault.empty()) return fault;
    mesh.holes.push_back(static_cast<Index>(face));
  }
  return {};
}

std::string give_boundary(const std::vector<long long>& rules, PolygonMesh& mesh) {
  if (rules.size() != 1 || rules[0] < 0 || rules[0] > 2) return "takes one rule, 0, 1 or 2";
  constexpr BoundaryRule meaning[] = {BoundaryRule::none, BoundaryRule::edges_and_corners,
                                      BoundaryRule::edges_only};
  mesh.boundary = meaning[rules[0]];
  return {};
}

std::string give_method(const std::vector<std::string>& words, PolygonMesh& mesh) {
  if (words.size() != 1 || (words[0] != "normal" && words[0] != "chaikin"))
    return "takes one method, normal or chaikin";
  mesh.crease_method = words[0] == "chaikin" ? CreaseMethod::chaikin : CreaseMethod::uniform;
  return {};
}

}  // namespace

std::string ObjTags::give(PolygonMesh& mesh, std::size_t vertices, std::size_t& number) const {
  for (const Tag& tag : tags_) {
    const Sharpness sharpness(tag.reals);
    const std::string fault = tag.name == "crease"   ? give_creases(tag.integers, sharpness, vertices, mesh)
                              : tag.name == "corner" ? give_corners(tag.integers, sharpness, vertices, mesh)
                              : tag.name == "hole"   ? give_holes(tag.integers, mesh)
                              : tag.name == "creasemethod" ? give_method(tag.words, mesh)
                                                           : give_boundary(tag.integers, mesh);
    number = tag.line;
    if (!fault.empty()) return fmt::format("tag {}: {}", tag.name, fault);
  }
  return {};
}

}  // namespace burin
