#pragma once
#include <burin/abi/param.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <span>

/// How a brush declares its parameters: constants of the class, one a parameter, and a list of them.
///
///   static constexpr FloatParam depth{.id = "depth", .name = "Depth", .unit = BURIN_UNIT_RADIUS,
///                                     .hard = {0, 10}, .soft = {0, 1}, .initial = 0.3f, .dynamic =
///                                     true};
///   static constexpr ChoiceParam profile{.id = "profile", .name = "Profile", .choices = {"round", "v"}};
///   static constexpr auto params = param_list(depth, profile);
///
/// `id` is what files and scripts store ([a-z0-9_]+, never to change), `name` and `help` are for people.
/// `dynamic` lets the host vary the value along the stroke (pen pressure, say). Mistakes, such as a default
/// outside of its range or an id used twice, stop the compiler.
namespace burin::plugin {

/// Without ends given, empty.
struct Range {
  float low = 0, high = 0;
};

/// Up to 32 texts ended by a null pointer.
class TextList {
 public:
  constexpr TextList() = default;
  template <std::convertible_to<const char*>... Texts>
  requires(sizeof...(Texts) >= 1 && sizeof...(Texts) <= 32) constexpr TextList(Texts... texts)
      : texts_{texts...}, size_(sizeof...(Texts)) {}

  constexpr const char* const* data() const { return texts_.data(); }
  constexpr std::size_t size() const { return size_; }

 private:
  std::array<const char*, 33> texts_{};
  std::size_t size_ = 0;
};

struct FloatParam {
  const char* id = nullptr;
  const char* name = nullptr;
  const char* help = nullptr;
  burin_param_unit unit = BURIN_UNIT_NONE;
  Range hard{0, 1};  ///< what the brush can compute with; ends may be infinite
  Range soft{};      ///< what a slider spans; without it the hard range
  float initial = 0;
  bool dynamic = false;
};

struct IntParam {
  const char* id = nullptr;
  const char* name = nullptr;
  const char* help = nullptr;
  Range hard{0, 1};  ///< whole numbers within +-2^24
  Range soft{};
  int initial = 0;
  bool dynamic = false;
};

struct BoolParam {
  const char* id = nullptr;
  const char* name = nullptr;
  const char* help = nullptr;
  bool initial = false;
  bool dynamic = false;
};

struct ChoiceParam {
  const char* id = nullptr;
  const char* name = nullptr;
  const char* help = nullptr;
  TextList choices{};  ///< stable ids; the value of the parameter is the index
  int initial = 0;
  bool dynamic = false;
};

struct ColourParam {
  const char* id = nullptr;
  const char* name = nullptr;
  const char* help = nullptr;
  std::array<float, 4> initial{0, 0, 0, 1};  ///< linear RGBA, 0..1
  bool dynamic = false;
};

struct FileParam {
  const char* id = nullptr;
  const char* name = nullptr;
  const char* help = nullptr;
  const char* initial = nullptr;  ///< without it the user must give a file; "" when none is needed
};

struct TextParam {
  const char* id = nullptr;
  const char* name = nullptr;
  const char* help = nullptr;
  const char* initial = "";  ///< UTF-8, one line
};

struct CurveParam {
  const char* id = nullptr;
  const char* name = nullptr;
  const char* help = nullptr;
  std::span<const float> initial{};  ///< x0 y0 x1 y1 ... of an array that lives on, x rising
};

}  // namespace burin::plugin
