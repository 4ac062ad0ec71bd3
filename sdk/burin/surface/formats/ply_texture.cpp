// Collects the texture coordinates of a PLY file from vertex properties or from lists of its faces.
#include <burin/surface/formats/ply_texture.h>

#include <algorithm>

namespace burin {
namespace {

constexpr std::string_view coordinate_names[][2] = {
    {"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}};

using Slots = std::vector<PlyTexture::Slot>;

/// Marks the first pair of names that the element has as lists, or as single numbers. Returns whether it has
/// one.
bool mark_pair(const PlyElement& element, bool lists, Slots& slots) {
  for (const auto& pair : coordinate_names) {
    const PlyProperty* found[] = {find_property(element, pair[0]), find_property(element, pair[1])};
    const auto fits = [&](const PlyProperty* p) { return p && p->count_type.has_value() == lists; };
    if (!fits(found[0]) || !fits(found[1])) continue;
    const auto at = [&](const PlyProperty* p) {
      return static_cast<std::size_t>(p - element.properties.data());
    };
    slots[at(found[0])] = PlyTexture::Slot::u;
    slots[at(found[1])] = PlyTexture::Slot::v;
    return true;
  }
  return false;
}

}  // namespace

std::vector<PlyTexture::Slot> PlyTexture::vertex_slots(const PlyElement& vertices) {
  Slots slots(vertices.properties.size(), Slot::none);
  mark_pair(vertices, false, slots);
  return slots;
}

std::vector<PlyTexture::Slot> PlyTexture::face_slots(const PlyElement& faces) {
  Slots slots(faces.properties.size(), Slot::none);
  if (mark_pair(faces, true, slots)) return slots;
  if (const PlyProperty* list = find_property(faces, "texcoord"); list && list->count_type)
    slots[static_cast<std::size_t>(list - faces.properties.data())] = Slot::both;
  return slots;
}

void PlyTexture::begin_vertices(std::size_t count, bool textured) {
  if (textured) vertices_.resize(count, Vec2f::Zero());
}

void PlyTexture::take(Slot slot, std::size_t vertex, double value) {
  if (slot == Slot::none) return;
  vertices_[vertex][slot == Slot::v] = static_cast<float>(value);
}

void PlyTexture::take_of_face(Slot slot, double value) {
  if (slot == Slot::none) return;
  (slot == Slot::both ? both_ : slot == Slot::u ? u_ : v_).push_back(static_cast<float>(value));
}

void PlyTexture::end_face(std::size_t corners) {
  for (std::size_t i = 0; i < corners; ++i) {
    if (both_.size() == 2 * corners) corners_.emplace_back(both_[2 * i], both_[2 * i + 1]);
    if (u_.size() == corners && v_.size() == corners) corners_.emplace_back(u_[i], v_[i]);
  }
  for (auto* list : {&u_, &v_, &both_}) list->clear();
}

std::vector<Vec2f> PlyTexture::of_corners(std::span<const Index> face_vertices) const {
  if (!corners_.empty()) return corners_.size() == face_vertices.size() ? corners_ : std::vector<Vec2f>{};
  if (std::ranges::any_of(face_vertices, [&](Index vertex) { return vertex >= vertices_.size(); })) return {};
  std::vector<Vec2f> uv(face_vertices.size());
  std::ranges::transform(face_vertices, uv.begin(), [&](Index vertex) { return vertices_[vertex]; });
  return uv;
}

}  // namespace burin
