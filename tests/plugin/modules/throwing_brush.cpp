// org.burin.test.throwing: throws what and where its parameters say.
#include <burin/plugin/plugin.h>

#include <new>
#include <stdexcept>

namespace {

using namespace burin::plugin;

class ThrowingBrush : public Brush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.test.throwing", .name = "Throwing", .vendor = "Burin", .version = "1.0.0"};
  enum Where { in_evaluate, in_begin };
  static constexpr ChoiceParam where{.id = "where", .name = "Where", .choices = {"evaluate", "begin"}};
  enum What { runtime_error, bad_alloc, number, not_found };
  static constexpr ChoiceParam what{
      .id = "what", .name = "What", .choices = {"runtime_error", "bad_alloc", "number", "not_found"}};
  static constexpr auto params = param_list(where, what);

  explicit ThrowingBrush(StrokeStart& start) {
    if (start.params[where].value() == in_begin) fail(start.params);
  }

  void evaluate(const Batch& in, const Outputs&) const override { fail(in.params); }

 private:
  [[noreturn]] static void fail(const Params& values) {
    switch (values[what].value()) {
      case bad_alloc:
        throw std::bad_alloc();
      case number:
        throw 42;
      case not_found:
        throw Error("gone", BURIN_NOT_FOUND);
      default:
        throw std::runtime_error("thrown\nby the brush");
    }
  }
};

}  // namespace

BURIN_PLUGIN(ThrowingBrush);
