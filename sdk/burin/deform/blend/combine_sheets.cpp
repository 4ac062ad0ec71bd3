// Combines the displacements and tints of the sheets at one vertex. Weights fade to 0 at the rim of each
// sheet, so that the result is continuous where sheets begin and end; see docs/overlap.md.
#include <burin/deform/blend/combine_sheets.h>
#include <burin/deform/blend/sheet_shares.h>
#include <burin/deform/blend/strongest.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <span>

namespace burin {
namespace {

using Tint64 = Eigen::Matrix<double, 5, 1>;

bool lies_before(const Sheet& a, const Sheet& b) {
  for (const Eigen::Index axis : {2, 0, 1})
    if (a.displacement[axis] != b.displacement[axis]) return a.displacement[axis] < b.displacement[axis];
  for (const Eigen::Index axis : {0, 1, 2})
    if (a.e1[axis] != b.e1[axis]) return a.e1[axis] < b.e1[axis];
  for (Eigen::Index channel = 0; channel < a.tint.size(); ++channel)
    if (a.tint[channel] != b.tint[channel]) return a.tint[channel] < b.tint[channel];
  return a.inside < b.inside;
}

/// Sorts sheets by their content, so that sums have the same bits in whatever order the sheets came.
void sort_by_content(std::vector<Sheet>& sheets) { std::ranges::stable_sort(sheets, lies_before); }

bool have_one_normal(std::span<const Sheet> sheets) {
  return std::ranges::all_of(sheets, [&](const Sheet& s) { return s.normal == sheets.front().normal; });
}

Vec3d mean_normal(std::span<const Sheet> sheets) {
  const Vec3d first = sheets.front().normal.cast<double>();
  if (have_one_normal(sheets)) return first.normalized();
  Vec3d sum = Vec3d::Zero();
  for (const Sheet& sheet : sheets) sum += sheet.normal.cast<double>();
  return sum.isZero(0) ? first.normalized() : sum.normalized();
}

/// Whether all moves are parallel to `direction`, up to rounding.
bool all_along(const Vec3d& direction, const std::vector<Vec3d>& moves) {
  return std::ranges::all_of(moves, [&](const Vec3d& move) {
    const double along = move.dot(direction);
    return (move - along * direction).squaredNorm() <= 1e-24 * along * along;
  });
}

template <class Value>
Value weighed(const std::vector<Value>& values, const Shares& shares) {
  Value sum = Value::Zero();
  for (std::size_t i = 0; i < values.size(); ++i) sum += shares[i] * values[i];
  return sum;
}

/// The sums of the values of each image's sheets, for the images that have any.
template <class Value>
std::vector<Value> sums_of_images(std::span<const Sheet> sheets, const std::vector<Value>& values) {
  std::map<std::uint32_t, Value> sums;
  for (std::size_t i = 0; i < sheets.size(); ++i)
    sums.try_emplace(sheets[i].image, Value::Zero()).first->second += values[i];
  std::vector<Value> list;
  list.reserve(sums.size());
  for (const auto& [image, sum] : sums) list.push_back(sum);
  return list;
}

/// The move of the sheets that move the vertex farthest along `direction`. The sideways part changes
/// continuously when another sheet becomes the farthest.
Vec3d farthest_along(const Vec3d& direction, std::span<const Sheet> sheets, const std::vector<Vec3d>& moves,
                     double radius) {
  std::vector<double> along;
  along.reserve(moves.size());
  for (const Vec3d& move : moves) along.push_back(move.dot(direction));
  const Shares shares = stacked_shares(sheets, along);
  double farthest = 0;
  for (std::size_t i = 0; i < along.size(); ++i) farthest += shares[i] * along[i];
  if (all_along(direction, moves)) return farthest * direction;
  const Vec3d sideways = weighed(moves, softly_stacked_shares(sheets, along, radius / 16));
  return sideways + (farthest - sideways.dot(direction)) * direction;
}

/// The greatest value of each channel, weighted by sheets; the least if `sign` is -1.
Tint64 most_of_each(std::span<const Sheet> sheets, const std::vector<Tint64>& tints, double sign) {
  Tint64 most;
  for (Eigen::Index channel = 0; channel < most.size(); ++channel) {
    std::vector<double> keys;
    keys.reserve(tints.size());
    for (const Tint64& tint : tints) keys.push_back(sign * tint[channel]);
    most[channel] = weighed(tints, stacked_shares(sheets, keys))[channel];
  }
  return most;
}

Tint64 strongest_of_each(const std::vector<Tint64>& changes) {
  Tint64 strong;
  for (Eigen::Index channel = 0; channel < strong.size(); ++channel) {
    std::vector<double> of_channel;
    of_channel.reserve(changes.size());
    for (const Tint64& change : changes) of_channel.push_back(change[channel]);
    strong[channel] = strongest(of_channel);
  }
  return strong;
}

}  // namespace

Vec3d combined_move(std::vector<Sheet> sheets, Overlap overlap, double radius) {
  const bool sums = overlap != Overlap::strongest || !have_one_normal(sheets);
  if (sums) sort_by_content(sheets);
  std::vector<Vec3d> moves;
  moves.reserve(sheets.size());
  for (const Sheet& sheet : sheets) moves.push_back(sheet.moved());
  const Vec3d normal = mean_normal(sheets);
  switch (overlap) {
    case Overlap::latest:
      return weighed(moves, latest_shares(sheets));
    case Overlap::average:
      return weighed(moves, mean_shares(sheets));
    case Overlap::max:
      return farthest_along(normal, sheets, moves, radius);
    case Overlap::min:
      return farthest_along(-normal, sheets, moves, radius);
    case Overlap::add:
      moves = sums_of_images(sheets, moves);
      return moves.size() == 1 ? moves.front() : strongest(moves, normal);
    default:
      return strongest(moves, normal);
  }
}

Tint combined_tint(std::vector<Sheet> sheets, Overlap overlap, const Tint& before) {
  sort_by_content(sheets);
  std::vector<Tint64> tints, changes;
  for (const Sheet& sheet : sheets) {
    tints.push_back(sheet.tint.cast<double>());
    changes.push_back((sheet.tint - before).cast<double>());
  }
  const auto changed = [&](const Tint64& change) {
    return Tint((before.cast<double>() + change).cwiseMax(0).cwiseMin(1).cast<float>());
  };
  switch (overlap) {
    case Overlap::latest:
      return weighed(tints, latest_shares(sheets)).cast<float>();
    case Overlap::average:
      return weighed(tints, mean_shares(sheets)).cast<float>();
    case Overlap::max:
      return most_of_each(sheets, tints, 1).cast<float>();
    case Overlap::min:
      return most_of_each(sheets, tints, -1).cast<float>();
    case Overlap::add:
      changes = sums_of_images(sheets, changes);
      return changed(changes.size() == 1 ? changes.front() : strongest_of_each(changes));
    default:
      return changed(strongest_of_each(changes));
  }
}

}  // namespace burin
