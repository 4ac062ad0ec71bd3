#include <burin/base/parallel.h>
#include <burin/deform/error_text.h>
#include <burin/deform/evaluate.h>
#include <burin/deform/first_failure.h>

#include <mutex>
#include <utility>

namespace burin {

/// Batches that are not in use. Not thread-local: a brush that runs parallel loops of its own may make a
/// thread start a second batch in the middle of the first.
class Evaluator::BatchPool {
 public:
  std::unique_ptr<Batch> take() {
    const std::lock_guard lock(mutex_);
    if (free_.empty()) return std::make_unique<Batch>();
    std::unique_ptr<Batch> batch = std::move(free_.back());
    free_.pop_back();
    return batch;
  }

  void give_back(std::unique_ptr<Batch> batch) {
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(batch));
  }

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<Batch>> free_;
};

namespace {

/// What one pass over the nodes has to do.
struct Pass {
  const BrushStroke& stroke;
  const burin_stroke_context& context;
  const NodeSource& source;
  std::span<const Index> nodes;
  std::span<Vec3f> displacement;
  FirstFailure& failure;
};

/// Computes the elements [begin, end) of the pass.
void evaluate_batch(const Pass& pass, Batch& batch, std::size_t begin, std::size_t end) {
  const std::span<Vec3f> displacement = pass.displacement.subspan(begin, end - begin);
  batch.fill(pass.source, pass.stroke.descriptor().inputs_read, pass.stroke.descriptor().outputs_written,
             pass.stroke.params(), pass.nodes.subspan(begin, end - begin),
             pass.context.pass == 0 ? std::span<const Vec3f>{} : displacement);
  ErrorText error;
  const burin_status status =
      pass.stroke.evaluate(pass.context, batch.inputs(), batch.outputs(), error.abi());
  if (status != BURIN_OK) return pass.failure.note(begin, error.line(status));
  for (std::size_t i = 0; i < displacement.size(); ++i) {
    displacement[i] = batch.displacement(i);
    if (displacement[i].allFinite()) continue;
    return pass.failure.note(begin + i, "returned a displacement that is not finite");
  }
}

void scale(const Pass& pass, float strength, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    pass.displacement[i] *= strength * pass.source.nodes.dynamics().strength(pass.nodes[i]);
    if (!pass.displacement[i].allFinite())
      return pass.failure.note(i, "displaces beyond the range of floats");
  }
}

}  // namespace

Evaluator::Evaluator() : pool_(std::make_unique<BatchPool>()) {}
Evaluator::~Evaluator() = default;

std::span<const Vec3f> Evaluator::evaluate(const BrushStroke& stroke, const burin_stroke_context& context,
                                           const NodeSource& source, std::span<const Index> nodes,
                                           float strength) {
  displacement_.resize(nodes.size());
  FirstFailure failure;
  burin_stroke_context now = context;
  const Pass pass{stroke, now, source, nodes, displacement_, failure};
  const auto throw_if_any = [&] {
    if (failure.any())
      failure.throw_at(stroke.descriptor().id, source.nodes.chart(), nodes[failure.element()]);
  };
  for (now.pass = 0; now.pass < stroke.plan().passes; ++now.pass) {
    parallel_blocks(nodes.size(), Batch::capacity, [&](std::size_t begin, std::size_t end) {
      if (failure.lies_before(begin)) return;
      std::unique_ptr<Batch> batch = pool_->take();
      evaluate_batch(pass, *batch, begin, end);
      pool_->give_back(std::move(batch));
    });
    throw_if_any();
  }
  parallel_blocks(nodes.size(), Batch::capacity,
                  [&](std::size_t begin, std::size_t end) { scale(pass, strength, begin, end); });
  throw_if_any();
  return displacement_;
}

}  // namespace burin
