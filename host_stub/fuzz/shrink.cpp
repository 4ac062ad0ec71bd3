// Leaves out and simplifies parts of a failing case as long as it fails [Zeller and Hildebrandt 2002].
#include "fuzz/shrink.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string>
#include <vector>

namespace burin {
namespace {

/// The number with so many significant digits.
double rounded(double value, int digits) {
  const std::string text = fmt::format("{:.{}e}", value, digits - 1);
  double result = 0;
  std::from_chars(text.data(), text.data() + text.size(), result);
  return result;
}

std::vector<std::string> keys_of(const Json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

class Shrinker {
 public:
  Shrinker(FuzzCase failing, const std::function<bool(const FuzzCase&)>& fails, int tries)
      : best_(std::move(failing)), fails_(fails), tries_(tries) {}

  FuzzCase run() {
    for (bool smaller = true; smaller && tries_ > 0;) {
      smaller = shrink_settings();
      smaller |= shrink_samples();
      smaller |= shrink_surface();
      smaller |= even_pen();
      smaller |= round_numbers();
    }
    return std::move(best_);
  }

 private:
  /// Takes the case in the place of the best one if it fails too.
  bool take(FuzzCase candidate) {
    if (tries_ <= 0) return false;
    --tries_;
    if (!fails_(candidate)) return false;
    best_ = std::move(candidate);
    return true;
  }

  /// Leaves out a setting, or a member of one.
  bool shrink_settings() {
    bool smaller = false;
    for (const std::string& key : keys_of(best_.trial.settings)) {
      if (key == "brush" || key == "radius") continue;
      FuzzCase without = best_;
      without.trial.settings.erase(key);
      if (take(std::move(without)))
        smaller = true;
      else if (key == "params")
        smaller |= shrink_params();
    }
    return smaller;
  }

  bool shrink_params() {
    bool smaller = false;
    for (const std::string& id : keys_of(best_.trial.settings["params"])) {
      FuzzCase without = best_;
      without.trial.settings["params"].erase(id);
      smaller |= take(std::move(without));
    }
    return smaller;
  }

  /// Leaves out runs of samples, long ones first.
  bool shrink_samples() {
    bool smaller = false;
    for (std::size_t run = best_.trial.stroke.samples.size() / 2; run > 0; run /= 2)
      for (std::size_t at = 0; at + run <= best_.trial.stroke.samples.size();) {
        if (run == best_.trial.stroke.samples.size()) break;
        FuzzCase without = best_;
        const auto first = without.trial.stroke.samples.begin() + static_cast<std::ptrdiff_t>(at);
        without.trial.stroke.samples.erase(first, first + static_cast<std::ptrdiff_t>(run));
        if (take(std::move(without)))
          smaller = true;
        else
          at += run;
      }
    return smaller;
  }

  template <class T>
  bool try_surface(T FuzzSurface::*member, T value) {
    if (best_.surface.*member == value) return false;
    FuzzCase other = best_;
    other.surface.*member = value;
    other.trial.mesh = surface_mesh(other.surface);
    return take(std::move(other));
  }

  bool shrink_surface() {
    bool smaller = try_surface(&FuzzSurface::holes, 0.0);
    smaller |= try_surface(&FuzzSurface::relief, 0.0);
    for (Index FuzzSurface::*side : {&FuzzSurface::columns, &FuzzSurface::rows})
      while (try_surface(side, std::max<Index>(best_.surface.*side / 2, 2))) smaller = true;
    return smaller;
  }

  /// A pen that presses evenly, upright.
  bool even_pen() {
    const PenFields few{.time = true};
    if (best_.trial.stroke.fields == few) return false;
    FuzzCase even = best_;
    even.trial.stroke.fields = few;
    for (Sample& sample : even.trial.stroke.samples) sample.pen = {};
    return take(std::move(even));
  }

  bool round_number(const Json::json_pointer& at) {
    const Json& value = best_.trial.settings[at];
    if (!value.is_number_float()) return false;
    for (const int digits : {1, 2, 3}) {
      const double number = value, round = rounded(number, digits);
      if (round == number) return false;
      FuzzCase rounder = best_;
      rounder.trial.settings[at] = round;
      if (take(std::move(rounder))) return true;
    }
    return false;
  }

  bool round_numbers() {
    bool smaller = false;
    const Json flat = best_.trial.settings.flatten();
    for (const std::string& place : keys_of(flat)) smaller |= round_number(Json::json_pointer(place));
    return smaller;
  }

  FuzzCase best_;
  const std::function<bool(const FuzzCase&)>& fails_;
  int tries_;
};

}  // namespace

FuzzCase shrunk(FuzzCase failing, const std::function<bool(const FuzzCase&)>& fails, int tries) {
  return Shrinker(std::move(failing), fails, tries).run();
}

}  // namespace burin
