// Fits strokes into the part of a view that shows a surface. The view is divided into cells; strokes of a
// given scale fit where all cells that they touch are among the seen ones, an erosion of a picture by a
// shape, which bits of whole rows make fast. The scale is bisected. Samples that miss the surface
// nevertheless, in a crack smaller than a cell, or that lie behind a step, take their cell out of the seen
// ones, and the search begins again. Where steps are everywhere, as on rough surfaces, strokes may cross
// them.
#include <burin/base/parallel.h>
#include <burin/base/vector.h>
#include <burin/ink/fit/fit_to_mesh.h>
#include <burin/ink/fit/fit_to_view.h>
#include <burin/ink/fit/seen_cells.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace burin {
namespace {

using Cell = std::pair<int, int>;  ///< column, row

/// What strokes touch when they fill the view: squares of half a cell, from the box's corner.
std::vector<Cell> touched_squares(const std::vector<RecordedStroke>& strokes, const Placement& filling,
                                  const Eigen::Vector2d& corner, double square) {
  constexpr int squares_along = 2 * 256 + 2;
  CellSet touched(squares_along, squares_along, false);
  const auto at = [&](const Sample& sample) {
    return Eigen::Vector2d((sample.position.head<2>() - corner) * (filling.scale / square));
  };
  for (const RecordedStroke& stroke : strokes)
    for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
      const Eigen::Vector2d to = at(stroke.samples[i]), from = i == 0 ? to : at(stroke.samples[i - 1]);
      const int steps = 1 + static_cast<int>(std::ceil(2 * (to - from).norm()));
      for (int step = 0; step <= steps; ++step) {
        const Eigen::Vector2d point = from + (to - from) * (static_cast<double>(step) / steps);
        touched.set(static_cast<int>(point.x()), static_cast<int>(point.y()), true);
      }
    }
  std::vector<Cell> squares;
  for (int row = 0; row < squares_along; ++row)
    for (int column = 0; column < squares_along; ++column)
      if (touched.has(column, row)) squares.emplace_back(column, row);
  return squares;
}

/// The cells that the squares touch when they are scaled, from the box's corner.
std::vector<Cell> touched_cells(const std::vector<Cell>& squares, double scale) {
  std::vector<Cell> cells;
  for (const auto& [column, row] : squares)
    for (int i = 0; i < 4; ++i)
      cells.emplace_back(static_cast<int>(scale * (column + i % 2) / 2),
                         static_cast<int>(scale * (row + i / 2) / 2));
  std::ranges::sort(cells);
  const auto rest = std::ranges::unique(cells);
  cells.erase(rest.begin(), rest.end());
  return cells;
}

/// The cells at which the box's corner may be for all touched cells to be in `seen`.
CellSet corners_for(const CellSet& seen, const std::vector<Cell>& touched) {
  CellSet corners(seen.columns(), seen.rows(), true);
  for (const auto& [column, row] : touched) corners.keep_where(seen, column, row);
  return corners;
}

/// The cell of a set that is nearest to the mean of all.
Cell middle_of(const CellSet& cells) {
  std::vector<Cell> all;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int row = 0; row < cells.rows(); ++row)
    for (int column = 0; column < cells.columns(); ++column)
      if (cells.has(column, row)) {
        all.emplace_back(column, row);
        sum += Eigen::Vector2d(column, row);
      }
  const Eigen::Vector2d mean = sum / static_cast<double>(all.size());
  return std::ranges::min(
      all, {}, [&](const Cell& cell) { return (Eigen::Vector2d(cell.first, cell.second) - mean).norm(); });
}

/// The cells all of whose neighbours are in the set too.
CellSet without_rim(const CellSet& cells) {
  CellSet inner(cells.columns(), cells.rows(), false);
  for (int row = 1; row + 1 < cells.rows(); ++row)
    for (int column = 1; column + 1 < cells.columns(); ++column) {
      bool whole = true;
      for (int i = 0; i < 9; ++i) whole = whole && cells.has(column - 1 + i % 3, row - 1 + i / 3);
      inner.set(column, row, whole);
    }
  return inner;
}

/// The greatest share of `filling` at which the squares fit, and where the box's corner is then.
std::optional<Placement> largest_placement(const CellSet& seen, const std::vector<Cell>& squares,
                                           const Placement& filling, const Eigen::Vector2d& corner,
                                           double cell) {
  constexpr int halvings = 10;
  std::optional<Placement> found;
  double fits = 0, too_large = 1;
  for (int i = 0; i < halvings; ++i) {
    const double share = (fits + too_large) / 2;
    const CellSet corners = corners_for(seen, touched_cells(squares, share));
    if (corners.empty()) {
      too_large = share;
      continue;
    }
    fits = share;
    const auto [column, row] = middle_of(corners);
    found = {share * filling.scale, corner, cell * Eigen::Vector2d(column, row)};
  }
  return found;
}

/// What becomes of a sample on the surface.
enum class Place : char { good, behind_step, missed };

/// Whether the surface goes on from one sample's place to the next one's: it is as near to points of the
/// chord as it must be for a stroke on it (stroke/curve/curve_ground.cpp).
bool goes_on(const Picker& picker, const Vec3f& from, const Vec3f& to) {
  const Vec3f chord = to - from;
  return from == to || std::ranges::all_of(std::array{0.25F, 0.5F, 0.75F}, [&](float share) {
           return picker.closest(from + share * chord, chord.norm() / 4).has_value();
         });
}

std::vector<Place> places_on(const RecordedStroke& stroke, const Camera& camera, const Picker& picker) {
  constexpr std::size_t samples_at_once = 256;
  std::vector<Place> places(stroke.samples.size(), Place::missed);
  std::vector<Vec3f> found(places.size());
  parallel_blocks(places.size(), samples_at_once, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3d& position = stroke.samples[i].position;
      const auto hit = picker.pick(pixel_ray(camera, position.x(), position.y()));
      if (!hit) continue;
      places[i] = Place::good;
      found[i] = hit->position;
    }
  });
  for (std::size_t i = 1; i < places.size(); ++i)
    if (places[i] == Place::good && places[i - 1] != Place::missed &&
        !goes_on(picker, found[i - 1], found[i]))
      places[i] = Place::behind_step;
  return places;
}

/// Takes a square of cells out of a set, so many on either side of one.
void take_out(CellSet& cells, const Cell& middle, int around) {
  for (int row = std::max(0, middle.second - around);
       row <= std::min(cells.rows() - 1, middle.second + around); ++row)
    for (int column = std::max(0, middle.first - around);
         column <= std::min(cells.columns() - 1, middle.first + around); ++column)
      cells.set(column, row, false);
}

/// Takes the cells of samples that are in no good place out of `seen`; returns the worst place of all.
Place take_out_bad(CellSet& seen, const std::vector<RecordedStroke>& strokes, const Camera& camera,
                   const Picker& picker) {
  Place worst = Place::good;
  for (const RecordedStroke& stroke : strokes) {
    const std::vector<Place> places = places_on(stroke, camera, picker);
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (places[i] == Place::good) continue;
      const Eigen::Vector2d at = stroke.samples[i].position.head<2>() / cell_size(camera);
      // Steps are lines, so that one goes on in the cells around.
      take_out(seen, {static_cast<int>(at.x()), static_cast<int>(at.y())},
               places[i] == Place::missed ? 0 : 2);
      worst = std::max(worst, places[i]);
    }
  }
  return worst;
}

/// From so many samples on, a search takes so long that fewer are made.
constexpr std::size_t many_samples = 100'000;

std::size_t samples_in(const std::vector<RecordedStroke>& strokes) {
  std::size_t count = 0;
  for (const RecordedStroke& stroke : strokes) count += stroke.samples.size();
  return count;
}

}  // namespace

bool fit_to_mesh(std::vector<RecordedStroke>& strokes, const Camera& camera, const Surface& surface) {
  const int most_searches = samples_in(strokes) < many_samples ? 60 : 20;
  const Picker picker(surface);
  const Eigen::AlignedBox2d box = flat_box_of(strokes);
  const Placement filling = view_placement(box, camera, 0);
  const double cell = cell_size(camera);
  const std::vector<Cell> squares = touched_squares(strokes, filling, box.min(), cell / 2);
  CellSet seen = without_rim(seen_cells(camera, picker));
  // The largest one of which all samples are seen, and the share of it to which steps may shrink a drawing.
  std::optional<Placement> all_seen;
  constexpr double smallest = 0.25;
  for (int search = 0; search < most_searches; ++search) {
    const auto placement = largest_placement(seen, squares, filling, box.min(), cell);
    if (!placement || (all_seen && placement->scale < smallest * all_seen->scale)) break;
    std::vector<RecordedStroke> placed = strokes;
    place(placed, *placement);
    const Place worst = take_out_bad(seen, placed, camera, picker);
    if (!all_seen && worst != Place::missed) all_seen = placement;
    if (worst != Place::good) continue;
    strokes = std::move(placed);
    return true;
  }
  if (all_seen) place(strokes, *all_seen);
  return all_seen.has_value();
}

}  // namespace burin
