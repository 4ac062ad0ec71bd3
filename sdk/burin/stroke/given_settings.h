#pragma once
#include <burin/stroke/stroke_settings.h>

#include <cstddef>
#include <functional>
#include <map>

namespace burin {

/// Settings of which some are given and the rest is left open, as those of a recording and of a command line:
///   given[&StrokeSettings::radius] = 0.1;
///   if (const double* radius = given.find(&StrokeSettings::radius)) ...
class GivenSettings {
 public:
  /// The setting, which is given from now on: the default unless it was before.
  template <class T, class Owner>
  T& operator[](T Owner::*member) {
    given_[offset(member)] = [member](const ReplaySettings& from, ReplaySettings& to) {
      to.*member = from.*member;
    };
    return values_.*member;
  }

  /// The setting, or nullptr when it is left open.
  template <class T, class Owner>
  const T* find(T Owner::*member) const {
    return given_.contains(offset(member)) ? &(values_.*member) : nullptr;
  }

  /// Leaves the setting open.
  template <class T, class Owner>
  void erase(T Owner::*member) {
    given_.erase(offset(member));
    values_.*member = ReplaySettings().*member;
  }

  /// Puts what is given in the place of what `settings` has.
  void apply_to(ReplaySettings& settings) const {
    for (const auto& [at, copy] : given_) copy(values_, settings);
  }

  /// What is given, and the defaults for the rest.
  ReplaySettings complete() const {
    ReplaySettings settings;
    apply_to(settings);
    return settings;
  }

 private:
  /// Tells members apart, bytes.
  template <class T, class Owner>
  std::ptrdiff_t offset(T Owner::*member) const {
    return reinterpret_cast<const char*>(&(values_.*member)) - reinterpret_cast<const char*>(&values_);
  }

  ReplaySettings values_;
  std::map<std::ptrdiff_t, std::function<void(const ReplaySettings&, ReplaySettings&)>> given_;
};

}  // namespace burin
