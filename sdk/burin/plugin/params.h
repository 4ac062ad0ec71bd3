#pragma once
#include <burin/abi/param.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <span>

/// A brush declares its parameters as constants of its class, one per parameter, and a list of them:
///
///   static constexpr FloatParam depth{.id = "depth", .name = "Depth", .unit = BURIN_UNIT_RADIUS,
///                                     .hard = {0, 10}, .soft = {0, 1}, .default_value = 0.3f, .dynamic =
///                                     true};
///   static constexpr ChoiceParam profile{.id = "profile", .name = "Profile", .choices = {"round", "v"}};
///   static constexpr auto params = param_list(depth, profile);
///
/// Files and scripts store `id` ([a-z0-9_]+, which must never change); `name` and `help` are for people.
/// `default_value` is the default. `dynamic` lets the host vary the value along the stroke, for example by
/// pen pressure. Mistakes, such as a default outside its range or an id used twice, are compile errors.
namespace burin::plugin {

/// A closed range of numbers; empty by default.
struct Range {
  float low = 0, high = 0;
};

/// Up to 32 texts, ended by a null pointer.
class TextList {
 public:
  constexpr TextList() = default;
  template <std::convertible_to<const char*>... Texts>
  requires(sizeof...(Texts) >= 1 && sizeof...(Texts) <= 32) constexpr TextList(Texts... texts)
      : texts_{texts...}, size_(sizeof...(Texts)) {}

  constexpr const char* const* data() const { return texts_.data(); }  ///< ended by a null pointer
  constexpr std::size_t size() const { return size_; }                 ///< number of texts

 private:
  std::array<const char*, 33> texts_{};
  std::size_t size_ = 0;
};

/// A number.
struct FloatParam {
  const char* id = nullptr;
  const char* name = nullptr;
  const char* help = nullptr;
  burin_param_unit unit = BURIN_UNIT_NONE;
  Range hard{0, 1};  ///< values that the brush accepts; ends may be infinite
  Range soft{};      ///< values that a slider spans; by default the hard range
  float default_value = 0;
  bool dynamic = false;
};

/// A whole number.
struct IntParam {
  const char* id = nullptr;
  const char* name = nullptr;
  const char* help = nullptr;
  Range hard{0, 1};  ///< whole numbers within +-2^24
  Range soft{};
  int default_value = 0;
  bool dynamic = false;
};

/// A truth value.
struct BoolParam {
  const char* id = nullptr;
  const char* name = nullptr;
  const char* help = nullptr;
  bool default_value = false;
  bool dynamic = false;
};

/// One of several choices.
struct ChoiceParam {
  const char* id = nullptr;
  const char* name = nullptr;
  const char* help = nullptr;
  TextList choices{};  ///< stable ids; the value of the parameter is an index into them
  int default_value = 0;
  bool dynamic = false;
};

/// A colour.
struct ColourParam {
  const char* id = nullptr;
  const char* name = nullptr;
  const char* help = nullptr;
  std::array<float, 4> default_value{0, 0, 0, 1};  ///< linear RGBA, 0..1
  bool dynamic = false;
};

/// The path of a file.
struct FileParam {
  const char* id = nullptr;
  const char* name = nullptr;
  const char* help = nullptr;
  const char* default_value = nullptr;  ///< null if the user must choose a file; "" if none is needed
};

/// A line of text.
struct TextParam {
  const char* id = nullptr;
  const char* name = nullptr;
  const char* help = nullptr;
  const char* default_value = "";  ///< UTF-8, one line
};

/// A piecewise linear function.
struct CurveParam {
  const char* id = nullptr;
  const char* name = nullptr;
  const char* help = nullptr;
  std::span<const float> default_value{};  ///< x0 y0 x1 y1 ..., x increasing, of an array with static storage
};

}  // namespace burin::plugin
