// Removes samples that no hand has drawn on purpose.
#include <burin/base/vector.h>
#include <burin/ink/mend/drawn_length.h>
#include <burin/ink/mend/mend_positions.h>
#include <burin/math/median.h>

#include <algorithm>
#include <vector>

namespace burin {
namespace {

/// The median of the steps that are not 0; 0 if there are none.
double median_step(const std::vector<Sample>& samples) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < samples.size(); ++i)
    if (const double length = step(samples[i - 1], samples[i]); length > 0) steps.push_back(length);
  if (steps.empty()) return 0;
  return math::median(steps);
}

/// Whether the way beyond a sample, to the first sample at least `distance` away from it, turns back by more
/// than 120 degrees against the direction in which the sample was reached.
bool turns_back(const std::vector<Sample>& samples, std::size_t i, const Vec3d& reached, double distance) {
  constexpr double most_cosine = -0.5;
  std::size_t beyond = i + 1;
  while (beyond < samples.size() && step(samples[i], samples[beyond]) < distance) ++beyond;
  if (beyond == samples.size()) return false;
  const Vec3d way = samples[beyond].position - samples[i].position;
  return reached.dot(way) < most_cosine * reached.norm() * way.norm();
}

/// The number of samples at the beginning that are a hook; `way` and `usual`: length and median step of the
/// whole stroke. The turn must be
/// sharp, near the hook and at its own length: a way that bends back later is drawn on purpose.
std::size_t hook_at_start(const std::vector<Sample>& samples, double way, double usual) {
  constexpr std::size_t longest = 6, least_samples = 4 * longest;
  constexpr double least_share = 30, straight = 1.2;
  if (samples.size() < least_samples) return 0;
  const double shortest = usual / 2;  // less is the tremble of a pen that rests
  std::size_t hook = 0;
  double gone = 0;
  for (std::size_t i = 1; i <= longest; ++i) {
    gone += step(samples[i - 1], samples[i]);
    const Vec3d reached = samples[i].position - samples[0].position;
    const double length = reached.norm();
    if (length < shortest || length == 0 || gone > straight * length || gone * least_share > way) continue;
    if (turns_back(samples, i, reached, length / 2) && turns_back(samples, i, reached, length)) hook = i;
  }
  return hook;
}

}  // namespace

void remove_wild_samples(RecordedStroke& stroke, MendLog& log) {
  constexpr double far = 10;
  std::vector<Sample>& samples = stroke.samples;
  const double usual = median_step(samples);
  const auto is_wild = [&](std::size_t i) {
    if (i == 0 || i + 1 == samples.size()) return false;
    const double nearest = std::min(step(samples[i - 1], samples[i]), step(samples[i], samples[i + 1]));
    return nearest > far * std::max(usual, step(samples[i - 1], samples[i + 1]));
  };
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (is_wild(i))
      log.add(i, i, "far beside the way; left out");
    else
      kept.push_back(i);
  }
  log.keep(kept, samples);
}

void remove_hooks(RecordedStroke& stroke, MendLog& log) {
  std::vector<Sample>& samples = stroke.samples;
  const double way = drawn_length(samples), usual = median_step(samples);
  const std::size_t at_start = hook_at_start(samples, way, usual);
  std::ranges::reverse(samples);
  const std::size_t at_end = hook_at_start(samples, way, usual);
  std::ranges::reverse(samples);
  if (at_end > 0)
    log.add(samples.size() - at_end, samples.size() - 1, "a hook of the pen that lifts; left out");
  if (at_start > 0) log.add(0, at_start - 1, "a hook of the pen that lands; left out");
  samples.erase(samples.end() - static_cast<std::ptrdiff_t>(at_end), samples.end());
  samples.erase(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(at_start));
}

}  // namespace burin
