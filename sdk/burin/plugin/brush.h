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

/// Describes a brush to the host: texts for people, and the inputs and outputs that the brush uses. A brush
/// class has it as `static constexpr BrushInfo info`.
struct BrushInfo {
  const char* id = nullptr;    ///< reverse DNS, "org.example.ripple": never changes
  const char* name = nullptr;  ///< for people
  const char* vendor = nullptr;
  const char* version = nullptr;  ///< of the brush, "1.2.0"
  const char* help = nullptr;     ///< one or two sentences
  TextList features{};            ///< tags such as "procedural", and exceptions: BURIN_FEATURE_*
  std::uint64_t inputs = BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS;  ///< bits BURIN_INPUT_*
  std::uint64_t outputs = BURIN_OUTPUT_DISPLACEMENT;                          ///< bits BURIN_OUTPUT_*
  /// How results are combined where a stroke overlaps itself, unless the user chooses another mode.
  burin_overlap overlap = BURIN_OVERLAP_STRONGEST;
  /// A displacement is at most this number times the distance to the rim, where the surface stays as it is.
  /// 0: not stated; infinity: it steps.
  float rim_slope = 0;
  /// The time that evaluate() takes at most, whatever the parameters, as a multiple of copying its declared
  /// inputs: what `burin bench-brush` prints (abi/ext/bench_budget.h). 0: not promised.
  double budget = 0;
};

/// The argument of a brush's constructor: a stroke that is about to begin. The constructor may set the last
/// two members to what the brush needs.
struct StrokeStart {
  Stroke stroke;            ///< of length 0
  Params params;            ///< all numbers uniform: the values before input dynamics
  Host host;                ///< for Log, Stamp and Lettering
  std::string module_path;  ///< the plugin's file, UTF-8, for files that lie beside it

  /// How far back from the end (object units, >= 0) results depend on Stroke::length() or finished(); may be
  /// infinite.
  double end_influence = 0;
  std::uint32_t passes =
      1;  ///< number of evaluations of the whole stroke, each on the result of the previous
};

/// A brush while it draws one stroke. Derive a class, describe it in static members and write evaluate():
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
/// Every stroke has an object of its own, made when the stroke begins and destroyed when it ends. Files and
/// tables that the stroke needs are members of it. Constructor and evaluate() may throw; the message reaches
/// the user.
class Brush {
 public:
  Brush() = default;
  Brush(const Brush&) = delete;
  Brush& operator=(const Brush&) = delete;
  virtual ~Brush() = default;

  /// Computes the outputs of every element of the batch from the inputs of that element alone. Runs on
  /// several threads at once. All values written must be finite; the host multiplies displacement by the
  /// strength of the stroke and the node's mask.
  virtual void evaluate(const Batch& in, const Outputs& out) const = 0;
};

}  // namespace burin::plugin
