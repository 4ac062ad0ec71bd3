#pragma once
#include <burin/abi/brush.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "validate/probe/nodes.h"
#include "validate/probe/plugin.h"
#include "validate/probe/probe_host.h"
#include "validate/probe/values.h"

namespace burin::validate {

/// What a brush wrote for a node: along, across, up, mask, r, g, b, a. Not declared outputs stay as filled.
using Row = std::array<float, 8>;

/// A brush of the plugin and values of its parameters. Throws Failed if it cannot be created.
class ProbeBrush {
 public:
  ProbeBrush(const Plugin& plugin, const burin_brush_descriptor& descriptor, const Subject& subject);
  ProbeBrush(const ProbeBrush&) = delete;
  ProbeBrush& operator=(const ProbeBrush&) = delete;
  ~ProbeBrush();

  const burin_brush_descriptor& descriptor;
  ProbeHost host;
  Values values;
  const burin_brush& abi() const { return *brush_; }

  /// Whether a stroke can begin, which is ended at once. `error` gets why not.
  bool begins(burin_text* error = nullptr);

  /// The brush's interface with this id, or null.
  template <class Interface>
  const Interface* interface(const char* id) const {
    return static_cast<const Interface*>(brush_->get_extension(brush_, id));
  }

 private:
  const burin_brush* brush_;
};

/// An open stroke, as long as its context says. `context` may be changed between calls.
class ProbeStroke {
 public:
  /// Begins. Throws Skipped if that fails and a file would be needed, else Failed.
  explicit ProbeStroke(ProbeBrush& brush, const burin_stroke_context& drawn = stroke_context());
  ProbeStroke(const ProbeStroke&) = delete;
  ProbeStroke& operator=(const ProbeStroke&) = delete;
  ~ProbeStroke();

  burin_stroke_context context;
  burin_stroke_plan plan{};
  void* self() const { return stroke_; }
  const burin_params& params() const { return *params_; }

  /// Evaluates all nodes in one batch. Throws Failed if the brush reports an error.
  std::vector<Row> evaluate(const Nodes& nodes) { return evaluate(nodes, 0, nodes.size()); }

  /// Evaluates the nodes from `begin` to before `end`. Any thread.
  std::vector<Row> evaluate(const Nodes& nodes, std::size_t begin, std::size_t end) const;

  /// Evaluates a batch that the caller made, without a word on errors.
  burin_status call(const burin_batch& batch, const burin_outputs& outputs, burin_text* text = nullptr) const;

 private:
  /// Returns why it failed, or nothing.
  std::string begin();

  ProbeBrush& brush_;
  const burin_params* params_;  ///< those of the time when the stroke began
  void* stroke_ = nullptr;
};

/// The batch of the nodes from `begin` on, with every array whether declared or not.
burin_batch batch_of(const Nodes& nodes, std::size_t begin, std::size_t count, const burin_params& params);

/// Makes outputs of rows, filled as a host fills them: no displacement, mask and colour before the stroke.
burin_outputs outputs_of(std::vector<Row>& rows);

/// The arrays of a batch, which input_columns() describes, and of outputs.
burin_floats& array_of(burin_batch& batch, const InputColumns& input, std::size_t member);
std::array<burin_floats_out*, 8> arrays_of(burin_outputs& outputs);

/// The name of one of the arrays of outputs, "along".
const char* output_name(std::size_t array);

/// Whether a brush declares this one of the arrays of outputs.
bool writes(const burin_brush_descriptor& brush, std::size_t array);

/// Where two results differ in their bits: "at t 3.2 and d -0.5 'along' is 1 and 2"; empty if they do not.
std::string difference(const std::vector<Row>& a, const std::vector<Row>& b, const Nodes& nodes);

/// The bytes of a result, to compare what two processes drew.
std::string bits_of(const std::vector<Row>& rows);

/// Throws Failed with the node and the output if a number of a result is not finite.
void require_finite(const std::vector<Row>& rows, const Nodes& nodes);

/// The largest absolute difference of two results.
float distance(const std::vector<Row>& a, const std::vector<Row>& b);

}  // namespace burin::validate
