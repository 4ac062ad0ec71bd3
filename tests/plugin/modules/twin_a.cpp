// org.burin.test.twin-a: its class and its parameter are called as those of the other twin.
#include <burin/plugin/plugin.h>

class Twin : public burin::plugin::Brush {
 public:
  static constexpr burin::plugin::BrushInfo info{
      .id = "org.burin.test.twin-a", .name = "Twin", .vendor = "Burin", .version = "1.0.0"};
  static constexpr burin::plugin::FloatParam size{.id = "size", .name = "Size", .default_value = 0.25f};
  static constexpr auto params = burin::plugin::param_list(size);

  void evaluate(const burin::plugin::Batch& in, const burin::plugin::Outputs& out) const override {
    for (std::size_t i = 0; i < in.size(); ++i) out.up()[i] = 1 + in.params[size].value();
  }
};

BURIN_PLUGIN(Twin);
