#pragma once
#include <burin/ink/decode/remarkable_order.h>
#include <burin/ink/parse/byte_reader.h>
#include <burin/ink/pen_file.h>

#include <Eigen/Core>
#include <map>
#include <optional>
#include <vector>

namespace burin {

/// What is in a layer or group of a page of reMarkable's version 6: a line, a group, or what a deleted one
/// left.
struct RemarkableItem {
  RemarkableId parent;
  RemarkableNeighbours neighbours;
  std::optional<RemarkableId> group;
  PenStroke stroke;  ///< without samples if it is no line
};

/// What ties a group of lines to typed text, with which the tablet moves them.
struct RemarkableAnchor {
  RemarkableId character;
  double x = 0;  ///< of the origin of the group's coordinates
};

/// The items of a page, and where its groups are.
struct RemarkableScene {
  std::vector<RemarkableItem> items;
  std::map<RemarkableId, RemarkableAnchor> anchors;  ///< by group
  std::map<RemarkableId, double> text_lines;         ///< y, by character

  /// Adds the lines to the content, layer by layer, in the order that their ids tell, whatever that of the
  /// items. A group belongs to the layer around it. Layers without lines do not count. Throws FileError,
  /// which names the byte at which `end` is, for groups within more than 100 others.
  void add_lines_to(PenFile& content, const ByteReader& end);

 private:
  struct Walk;
  Eigen::Vector2d origin_of(RemarkableId group) const;
};

}  // namespace burin
