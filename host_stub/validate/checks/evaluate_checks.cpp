// Checks what evaluate reads and writes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "validate/probe/repeat.h"
#include "validate/probe/stroke.h"
#include "validate/probe/varying_params.h"

namespace burin::validate {
namespace {

using Brush = burin_brush_descriptor;
constexpr float padding = -7;  ///< between the numbers of arrays

void each_stroke(const Subject& subject, const std::function<void(ProbeBrush&, ProbeStroke&)>& check) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    ProbeBrush brush(plugin, descriptor, subject);
    ProbeStroke stroke(brush);
    check(brush, stroke);
  });
}

void check_bounded(const Subject& subject) {
  each_stroke(subject, [&](ProbeBrush&, ProbeStroke& stroke) {
    const Nodes nodes = random_nodes(1999, subject.seed);
    const auto rows = stroke.evaluate(nodes);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const float moved = std::hypot(rows[i][0], rows[i][1], rows[i][2]);
      require(!(moved > 1000), fmt::format("moves a node at t {} and d {} by {}: more than 1000 radii",
                                           nodes.t(i), nodes.d(i), moved));
    }
  });
}

/// Evaluates so many nodes in another process, for which a brush may have no room.
void try_size(const ProbeStroke& stroke, const Nodes& nodes, std::size_t size) {
  try {
    in_process([&] {
      stroke.evaluate(nodes, 0, size);
      return std::string();
    });
  } catch (const Crashed&) {
    throw Failed(fmt::format("crashes with a batch of {} nodes; hosts may pass any number", size));
  }
}

void check_sizes(const Subject& subject) {
  each_stroke(subject, [&](ProbeBrush&, ProbeStroke& stroke) {
    const Nodes nodes = random_nodes(65536, subject.seed);
    for (const std::size_t size : {1, 255, 256, 257, 4096, 65536}) try_size(stroke, nodes, size);
    const auto all = stroke.evaluate(nodes);
    for (const std::size_t size : {1, 255, 256, 257, 4096}) {
      auto part = stroke.evaluate(nodes, 0, size);
      const std::string other = difference(part, all, nodes);
      require(other.empty(), fmt::format("a batch of {} differs from one of 65536: {}", size, other));
    }
  });
}

/// Evaluates batches of so many nodes, the last of which may be smaller.
std::vector<Row> evaluate_parts(const ProbeStroke& stroke, const Nodes& nodes, const VaryingParams& params,
                                std::size_t size) {
  std::vector<Row> all;
  for (std::size_t begin = 0; begin < nodes.size(); begin += size) {
    const std::size_t count = std::min(size, nodes.size() - begin);
    const VaryingParams::Part part = params.from(begin);
    std::vector<Row> rows(count);
    require(stroke.call(batch_of(nodes, begin, count, part.abi()), outputs_of(rows)) == BURIN_OK,
            fmt::format("evaluate fails with {} nodes whose numbers vary", count));
    all.insert(all.end(), rows.begin(), rows.end());
  }
  return all;
}

/// The batch with the numbers of its first node for all: as arrays, or with stride 0.
std::vector<Row> with_stride(ProbeStroke& stroke, Nodes nodes, std::uint32_t stride) {
  for (auto& column : nodes.columns) std::fill(column.begin(), column.end(), column[0]);
  burin_batch batch = batch_of(nodes, 0, nodes.size(), stroke.params());
  for (const InputColumns& input : input_columns())
    for (std::size_t k = 0; k < input.count; ++k) array_of(batch, input, k).stride = stride;
  std::vector<Row> rows(nodes.size());
  require(stroke.call(batch, outputs_of(rows)) == BURIN_OK,
          fmt::format("evaluate fails with stride {}", stride));
  return rows;
}

void check_stride_zero(const Subject& subject) {
  each_stroke(subject, [&](ProbeBrush&, ProbeStroke& stroke) {
    const Nodes nodes = random_nodes(100, subject.seed);
    const std::string other = difference(with_stride(stroke, nodes, 1), with_stride(stroke, nodes, 0), nodes);
    require(other.empty(), "stride 0 and an array of one number differ: " + other);
  });
}

void check_wide_strides(const Subject& subject) {
  each_stroke(subject, [&](ProbeBrush&, ProbeStroke& stroke) {
    Nodes nodes = random_nodes(100, subject.seed), wide = nodes;
    for (auto& column : wide.columns) {
      std::vector<float> spread(3 * column.size(), padding);
      for (std::size_t i = 0; i < column.size(); ++i) spread[3 * i] = column[i];
      column = spread;
    }
    burin_batch batch = batch_of(wide, 0, nodes.size(), stroke.params());
    for (const InputColumns& input : input_columns())
      for (std::size_t k = 0; k < input.count; ++k) array_of(batch, input, k).stride = 3;
    std::vector<Row> rows(nodes.size());
    require(stroke.call(batch, outputs_of(rows)) == BURIN_OK, "evaluate fails with stride 3");
    const std::string other = difference(stroke.evaluate(nodes), rows, nodes);
    require(other.empty(), "stride 3 and stride 1 differ: " + other);
  });
}

void check_varying(const Subject& subject) {
  each_stroke(subject, [&](ProbeBrush& brush, ProbeStroke& stroke) {
    stroke.context.radius_max = largest_varied_radius;
    Nodes nodes = random_nodes(500, subject.seed);
    vary(nodes);
    const VaryingParams params(brush.descriptor, stroke.params(), nodes);
    const auto whole = evaluate_parts(stroke, nodes, params, nodes.size());
    const std::string other = difference(evaluate_parts(stroke, nodes, params, 7), whole, nodes);
    require(other.empty(),
            "where radii, the pen or dynamic parameters vary, a batch of 7 differs from one of "
            "500, as if numbers of one node were used for all: " +
                other);
  });
}

void check_output_strides(const Subject& subject) {
  each_stroke(subject, [&](ProbeBrush&, ProbeStroke& stroke) {
    const Nodes nodes = random_nodes(100, subject.seed);
    const auto rows = stroke.evaluate(nodes);  // stride 8
    std::vector<Row> before(100);
    outputs_of(before);
    for (const std::uint32_t stride : {1u, 3u}) {
      std::array<std::vector<float>, 8> spread;
      burin_outputs outputs{sizeof outputs, 100, {}, {}, {}, {}, {}};
      const auto arrays = arrays_of(outputs);
      for (std::size_t k = 0; k < spread.size(); ++k) {
        spread[k].assign(100 * stride, padding);
        for (std::size_t i = 0; i < before.size(); ++i) spread[k][i * stride] = before[i][k];
        *arrays[k] = {spread[k].data(), stride, 0};
      }
      require(stroke.call(batch_of(nodes, 0, 100, stroke.params()), outputs) == BURIN_OK,
              fmt::format("evaluate fails with outputs of stride {}", stride));
      for (std::size_t k = 0; k < spread.size(); ++k)
        for (std::size_t i = 0; i < spread[k].size(); ++i) {
          const float expected = i % stride == 0 ? rows[i / stride][k] : padding;
          require(std::memcmp(&spread[k][i], &expected, sizeof(float)) == 0,
                  fmt::format("with outputs of stride {} and of 8 '{}' at t {} and d {} differs", stride,
                              output_name(k), nodes.t(i / stride), nodes.d(i / stride)));
        }
    }
  });
}

void check_inputs_unchanged(const Subject& subject) {
  each_stroke(subject, [&](ProbeBrush&, ProbeStroke& stroke) {
    const Nodes nodes = random_nodes(500, subject.seed), before = nodes;
    const burin_batch batch = batch_of(nodes, 0, nodes.size(), stroke.params()), batch_before = batch;
    std::vector<Row> rows(nodes.size());
    stroke.call(batch, outputs_of(rows));
    require(std::memcmp(&batch, &batch_before, sizeof batch) == 0, "evaluate changes the batch");
    std::size_t column = 0;
    for (const InputColumns& input : input_columns())
      for (std::size_t k = 0; k < input.count; ++k, ++column)
        require(std::memcmp(nodes.columns[column].data(), before.columns[column].data(),
                            500 * sizeof(float)) == 0,
                fmt::format("evaluate changes the input '{}'", input.name));
  });
}

void check_declared_outputs(const Subject& subject) {
  each_stroke(subject, [&](ProbeBrush& brush, ProbeStroke& stroke) {
    const Nodes nodes = random_nodes(500, subject.seed);
    std::vector<Row> rows(nodes.size());
    const burin_outputs outputs = outputs_of(rows);
    // No brush writes this by chance, as it may the values before the stroke.
    for (Row& row : rows)
      for (std::size_t k = 0; k < 8; ++k)
        if (!writes(brush.descriptor, k)) row[k] = padding;
    require(stroke.call(batch_of(nodes, 0, nodes.size(), stroke.params()), outputs) == BURIN_OK,
            "evaluate fails");
    for (const Row& row : rows)
      for (std::size_t k = 0; k < 8; ++k)
        require(writes(brush.descriptor, k) || row[k] == padding,
                fmt::format("writes the output '{}' without declaring it", output_name(k)));
  });
}

void check_odd_numbers(const Subject& subject) {
  using Limits = std::numeric_limits<float>;
  each_stroke(subject, [&](ProbeBrush&, ProbeStroke& stroke) {
    const Nodes nodes = random_nodes(64, subject.seed);
    for (const float number : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(),
                               Limits::denorm_min(), Limits::max(), Limits::lowest(), 0.0f})
      for (std::size_t column = 0; column < column_count; ++column) {
        Nodes odd = nodes;
        std::fill(odd.columns[column].begin(), odd.columns[column].end(), number);
        std::vector<Row> rows(odd.size());
        const burin_status status =
            stroke.call(batch_of(odd, 0, odd.size(), stroke.params()), outputs_of(rows));
        // Of t and d, which pass 0 and numbers near it wherever a stroke goes, this must be fine.
        const bool usual = column < 2 && std::abs(number) < 1;
        for (const Row& row : rows)
          for (const float result : row)
            require(!usual || (status == BURIN_OK && std::isfinite(result)),
                    fmt::format("where {} is {} it fails or writes a number that is not finite",
                                column == 0 ? "t" : "d", number));
      }
  });
}

void check_dab(const Subject& subject) {
  each_stroke(subject, [&](ProbeBrush&, ProbeStroke& stroke) {
    stroke.context.flags = BURIN_STROKE_DAB | BURIN_STROKE_FINAL;
    stroke.context.length = 0;
    stroke.context.dab_t = 3;
    const std::array<float, 5> t = {0, 0.5f, -0.5f, 0.9f, 0}, d = {0, 0.5f, 0.2f, -0.1f, -1};
    const Nodes nodes = nodes_at(t, d);
    require_finite(stroke.evaluate(nodes), nodes);
  });
}

void check_short(const Subject& subject) {
  each_stroke(subject, [&](ProbeBrush&, ProbeStroke& stroke) {
    const Nodes nodes = random_nodes(200, subject.seed);
    for (const double length : {0.0, 1e-6, 0.1, 1e4}) {
      stroke.context.length = length;
      for (const std::uint64_t flags : {std::uint64_t{0}, BURIN_STROKE_FINAL}) {
        stroke.context.flags = flags;
        tell_where(fmt::format("on a stroke of length {} it ", length),
                   [&] { require_finite(stroke.evaluate(nodes), nodes); });
      }
    }
  });
}

constexpr Check evaluate_list[] = {
    {"evaluate.bounded", 1, "stroke.h: a displacement is at most 1000 radii long",
     "Measures displacements of 1999 nodes.", check_bounded},
    {"evaluate.batch-sizes", 2, "stroke.h: count, usually 256 .. 4096, at least 1, at most 2^31",
     "Evaluates batches of 1, 255, 256, 257, 4096 and 65536 nodes.", check_sizes},
    {"evaluate.stride-zero", 2, "base.h: stride 0 gives one value for all elements",
     "Compares with arrays of one value.", check_stride_zero},
    {"evaluate.wide-strides", 2, "base.h: element i is data[i * stride]",
     "Compares inputs of stride 1 and 3.", check_wide_strides},
    {"evaluate.varying", 2, "stroke.h: one element per node; param.h: dynamic parameters have one too",
     "Compares small batches with large ones where radii, the pen and dynamic parameters vary.",
     check_varying},
    {"evaluate.output-strides", 2, "base.h: element i is data[i * stride]",
     "Compares outputs of stride 1, 3 and 8, and looks at what lies between them.", check_output_strides},
    {"evaluate.inputs-unchanged", 1, "brush.h: evaluate computes the outputs and changes nothing else",
     "Compares all inputs before and after.", check_inputs_unchanged},
    {"evaluate.declared-outputs", 2, "stroke.h: outputs_written",
     "Looks whether outputs that are not declared are written.", check_declared_outputs},
    {"evaluate.odd-numbers", 3,
     "stroke.h: with inputs that are not finite a brush may fail but must not crash; values written must be "
     "finite",
     "Fills each input with NaN, infinities, denormals, huge numbers and 0.", check_odd_numbers},
    {"evaluate.dab", 2, "stroke.h: BURIN_STROKE_DAB", "Draws a dab.", check_dab},
    {"evaluate.lengths", 2, "stroke.h: length of the stroke so far",
     "Draws strokes of no length, of little and of much.", check_short},
};

}  // namespace

std::span<const Check> evaluate_checks() { return evaluate_list; }

}  // namespace burin::validate
