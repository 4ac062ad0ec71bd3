#pragma once
#include <burin/deform/blend/earlier_pieces.h>
#include <burin/deform/blend/sheet.h>
#include <burin/deform/evaluate/displacement.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// All nodes of a stroke. Non-owning.
struct StrokeSheets {
  std::span<const InstanceSheets> instances;  ///< [image] nodes of the current piece
  const EarlierPieces* earlier = nullptr;     ///< null: none
};

/// The sheets of one vertex. The stroke's sheets must outlive the object.
class VertexSheets {
 public:
  /// `radius` is that of the stroke, object units.
  VertexSheets(const StrokeSheets& stroke, double radius, Index vertex)
      : stroke_(&stroke),
        radius_(radius),
        vertex_(vertex),
        earlier_(stroke.earlier && stroke.earlier->count() > 0 ? stroke.earlier->at(vertex)
                                                               : std::span<const Sheet>{}),
        count_(earlier_.size()) {
    for_each_node([this](std::uint32_t image, Index slot) {
      if (count_++ > earlier_.size()) return;
      first_image_ = image;
      first_slot_ = slot;
    });
  }

  std::size_t count() const { return count_; }

  /// The position and the tint of a vertex with exactly one sheet; `base` is its original position.
  Vec3f alone_moved(const Vec3f& base) const {
    if (!earlier_.empty()) {
      const Sheet& only = earlier_.front();
      return displaced(base, only.e1, only.normal, only.displacement);
    }
    const Chart& nodes = first().chart->nodes();
    return displaced(base, nodes.e1[first_slot_], nodes.normal[first_slot_],
                     first().outputs->displacement[first_slot_]);
  }
  Tint alone_tint() const {
    return earlier_.empty() ? first().outputs->tint[first_slot_] : earlier_.front().tint;
  }

  std::vector<Sheet> all() const {
    std::vector<Sheet> sheets(earlier_.begin(), earlier_.end());
    sheets.reserve(count_);
    for_each_node([&](std::uint32_t image, Index slot) { sheets.push_back(sheet(image, slot)); });
    return sheets;
  }

  /// Calls visit(image, slot) for the nodes of the current piece, image by image, in the order of t.
  template <class Visit>
  void for_each_node(const Visit& visit) const {
    for (std::uint32_t image = 0; image < stroke_->instances.size(); ++image) {
      const LiveChart& chart = *stroke_->instances[image].chart;
      for (Index slot = chart.first(vertex_); slot != no_index; slot = chart.next(slot)) visit(image, slot);
    }
  }

 private:
  const InstanceSheets& first() const { return stroke_->instances[first_image_]; }
  Sheet sheet(std::uint32_t image, Index slot) const {
    const std::uint32_t piece = stroke_->earlier ? stroke_->earlier->count() : 0;
    return stroke_->instances[image].sheet(slot, radius_, piece, image);
  }

  const StrokeSheets* stroke_;
  double radius_;
  Index vertex_;
  std::span<const Sheet> earlier_;
  std::size_t count_;
  std::uint32_t first_image_ = 0;  ///< image and slot of the first node of the current piece, if there is one
  Index first_slot_ = no_index;
};

}  // namespace burin
