#include <burin/deform/earlier_pieces.h>

namespace burin {
namespace {

/// How much of what earlier pieces and a later one do counts in their sum.
struct Weights {
  double earlier = 1, later = 1;
};

Weights weights(Overlap overlap, double earlier, double later) {
  if (overlap != Overlap::average) return {};
  return {earlier / (earlier + later), later / (earlier + later)};
}

}  // namespace

void EarlierPieces::blend(const Paint& paint, const PieceMoves& piece) const {
  if (left_.empty()) return;
  for (std::size_t i = 0; i < piece.vertices.size(); ++i) {
    const Index vertex = piece.vertices[i];
    const auto found = left_.find(vertex);
    if (found == left_.end()) continue;
    const Left& earlier = found->second;
    const bool alone = piece.sheets[i] == 0;
    piece.places[i] = alone ? earlier.place : place(earlier, vertex, piece.sheets[i], piece.places[i]);
    if (piece.tints.empty()) continue;
    const Tint before = tint_of(paint.colour_of(vertex), paint.mask_of(vertex));
    piece.tints[i] = alone ? earlier.tint : tint(earlier, before, piece.sheets[i], piece.tints[i]);
  }
}

void EarlierPieces::add(const PieceMoves& piece) {
  for (std::size_t i = 0; i < piece.vertices.size(); ++i) {
    if (piece.sheets[i] == 0) continue;
    Left& left = left_[piece.vertices[i]];
    left.sheets += piece.sheets[i];
    left.place = piece.places[i];
    if (!piece.tints.empty()) left.tint = piece.tints[i];
  }
}

Vec3f EarlierPieces::place(const Left& earlier, Index vertex, std::uint32_t sheets,
                           const Vec3f& later) const {
  const Vec3f& base = surface_->positions[vertex];
  if (options_.overlap == Overlap::latest) return later;
  if (options_.overlap == Overlap::max || options_.overlap == Overlap::min) {
    const float farther_out = (earlier.place - later).dot(surface_->normals[vertex]);
    return (options_.overlap == Overlap::max ? farther_out > 0 : farther_out < 0) ? earlier.place : later;
  }
  const auto [of_earlier, of_later] = weights(options_.overlap, earlier.sheets, sheets);
  const Vec3d moved =
      of_earlier * (earlier.place - base).cast<double>() + of_later * (later - base).cast<double>();
  const double distance = moved.norm();
  const double within = distance > options_.limit ? options_.limit / distance : 1;
  return (base.cast<double>() + within * moved).cast<float>();
}

Tint EarlierPieces::tint(const Left& earlier, const Tint& before, std::uint32_t sheets,
                         const Tint& later) const {
  switch (options_.overlap) {
    case Overlap::latest:
      return later;
    case Overlap::max:
      return later.cwiseMax(earlier.tint);
    case Overlap::min:
      return later.cwiseMin(earlier.tint);
    default:
      break;
  }
  const auto [of_earlier, of_later] = weights(options_.overlap, earlier.sheets, sheets);
  const Tint sum = static_cast<float>(of_earlier) * (earlier.tint - before) +
                   static_cast<float>(of_later) * (later - before);
  return (before + sum).cwiseMax(0).cwiseMin(1);
}

}  // namespace burin
