#pragma once
#include <burin/plugin/batch.h>
#include <burin/plugin/detail/host.h>
#include <burin/plugin/detail/param_list.h>
#include <burin/plugin/detail/param_values.h>
#include <burin/plugin/outputs.h>
#include <burin/plugin/stroke.h>

#include <cstdint>
#include <string>

namespace burin::plugin {

/// What a host shows of a brush, and what the brush reads and writes: `static constexpr BrushInfo info`.
struct BrushInfo {
  const char* id = nullptr;    ///< reverse DNS, "org.example.ripple": never changes
  const char* name = nullptr;  ///< for people
  const char* vendor = nullptr;
  const char* version = nullptr;  ///< of the brush, "1.2.0"
  const char* help = nullptr;     ///< one or two sentences
  TextList features{};            ///< tags such as "procedural", "stamp"
  std::uint64_t inputs = BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS;
  std::uint64_t outputs = BURIN_OUTPUT_DISPLACEMENT;
  /// What holds where a stroke overlaps itself, unless the user chooses another.
  burin_overlap overlap = BURIN_OVERLAP_STRONGEST;
};

/// A stroke about to begin: what the constructor of a brush gets, and where it says what it needs.
struct StrokeStart {
  Stroke stroke;            ///< of length 0
  Params params;            ///< every number uniform: the values before input dynamics
  Host host;                ///< for Log and Stamp
  std::string module_path;  ///< the plugin's file, UTF-8, for files that lie beside it

  /// How far back from the end (object units) results depend on Stroke::length() or finished(); may be
  /// infinite.
  double end_influence = 0;
  std::uint32_t passes = 1;  ///< evaluations of the whole stroke, each on what the one before left
};

/// A brush while it draws one stroke. Derive a class, tell about it in static members, write one evaluate:
///
///   class Ripple : public Brush {
///    public:
///     static constexpr BrushInfo info{...};
///     static constexpr auto params = param_list(...);          // if it has parameters
///     explicit Ripple(StrokeStart& start);                     // if it prepares something
///     void evaluate(const Batch& in, const Outputs& out) const override;
///   };
///   BURIN_PLUGIN(Ripple);                                      // once per module, at global scope
///
/// Every stroke has an object of its own, made when the stroke begins and destroyed when it ends: files and
/// tables that the stroke needs are members. Exceptions are welcome everywhere and reach the user as text.
class Brush {
 public:
  Brush() = default;
  Brush(const Brush&) = delete;
  Brush& operator=(const Brush&) = delete;
  virtual ~Brush() = default;

  /// Computes the outputs of every element of the batch from that element's inputs alone. Runs on several
  /// threads at once. All values written must be finite; the host scales displacement by the strength of
  /// the stroke.
  virtual void evaluate(const Batch& in, const Outputs& out) const = 0;
};

}  // namespace burin::plugin
