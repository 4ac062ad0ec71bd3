// Walks the layers and groups of a reMarkable page, as a tree from its root.
#include <burin/ink/decode/remarkable_scene.h>

#include <cstddef>
#include <set>
#include <utility>

namespace burin {
namespace {

constexpr RemarkableId root{0, 1};
constexpr std::size_t deepest = 100;

}  // namespace

/// What a walk has found.
struct RemarkableScene::Walk {
  /// Where the coordinates of a group begin.
  struct Place {
    Eigen::Vector2d origin = Eigen::Vector2d::Zero();
    bool beside_text = false;
  };

  RemarkableScene& scene;
  PenFile& content;
  const ByteReader& end;
  std::map<RemarkableId, std::vector<std::size_t>>
      items_of;  ///< by layer or group, places in the scene's items
  std::set<RemarkableId> seen;
  std::size_t layers = 0;

  std::vector<std::size_t> in_order(RemarkableId group) const {
    const auto found = items_of.find(group);
    if (found == items_of.end()) return {};
    std::vector<RemarkableNeighbours> neighbours;
    for (const std::size_t item : found->second) neighbours.push_back(scene.items[item].neighbours);
    std::vector<std::size_t> order = order_of(neighbours);
    for (std::size_t& place : order) place = found->second[place];
    return order;
  }

  /// Adds the lines of a layer, or of a group at `depth` groups in it, in `around`.
  void add_group(RemarkableId group, Place around, std::size_t depth) {
    if (!seen.insert(group).second) return;
    if (depth > deepest) end.reject("groups within more than 100 others");
    around.origin += scene.origin_of(group);
    around.beside_text = around.beside_text || scene.anchors.contains(group);
    for (const std::size_t i : in_order(group)) {
      RemarkableItem& item = scene.items[i];
      if (item.group) add_group(*item.group, around, depth + 1);
      if (!item.stroke.samples.empty()) add_line(std::move(item.stroke), around);
    }
  }

  void add_line(PenStroke stroke, const Place& place) {
    for (Sample& sample : stroke.samples) sample.position.head<2>() += place.origin;
    stroke.estimated_y = place.beside_text;
    stroke.layer = layers + 1;
    content.strokes.push_back(std::move(stroke));
  }

  void add_layer(RemarkableId layer) {
    const std::size_t before = content.strokes.size();
    add_group(layer, Place(), 0);
    layers += content.strokes.size() > before;
  }
};

Eigen::Vector2d RemarkableScene::origin_of(RemarkableId group) const {
  const auto anchor = anchors.find(group);
  if (anchor == anchors.end()) return Eigen::Vector2d::Zero();
  const auto line = text_lines.find(anchor->second.character);
  return {anchor->second.x, line == text_lines.end() ? 0 : line->second};
}

void RemarkableScene::add_lines_to(PenFile& content, const ByteReader& end) {
  Walk walk{*this, content, end, {}, {}};
  for (std::size_t i = 0; i < items.size(); ++i) walk.items_of[items[i].parent].push_back(i);
  for (const std::size_t i : walk.in_order(root))
    if (items[i].group) walk.add_layer(*items[i].group);
  // Of what the root does not lead to, each parent is a layer.
  for (const RemarkableItem& item : items) walk.add_layer(item.parent);
}

}  // namespace burin
