#pragma once
#include <burin/abi/brush.h>

#include <cstdint>
#include <vector>

namespace burin::test {

/// Parameters that are in order, one of each type, to be broken by tests.
inline burin_param_info param_of(burin_param_type type, const char* id) {
  static const char* const choices[] = {"round", "v", nullptr};
  static const float knots[] = {0, 1, 2, 3};
  burin_param_info info{};
  info.struct_size = sizeof(info);
  info.type = type;
  info.id = id;
  info.name = "A parameter";
  info.unit = BURIN_UNIT_NONE;
  info.hard_min = 0;
  info.hard_max = 4;
  info.soft_min = 0;
  info.soft_max = 2;
  info.default_number = 1;
  info.choices = type == BURIN_PARAM_CHOICE ? choices : nullptr;
  info.default_knots = type == BURIN_PARAM_CURVE ? knots : nullptr;
  info.default_knot_count = type == BURIN_PARAM_CURVE ? 2 : 0;
  info.default_text = type == BURIN_PARAM_TEXT ? "a line" : nullptr;
  return info;
}

/// The descriptor of a brush with these parameters; stays in place.
class Descriptor {
 public:
  explicit Descriptor(std::vector<burin_param_info> params) : infos_(std::move(params)) {
    for (const burin_param_info& info : infos_) pointers_.push_back(&info);
    abi.struct_size = sizeof(abi);
    abi.param_count = static_cast<std::uint32_t>(pointers_.size());
    abi.id = "org.burin.test.brush";
    abi.name = "A brush";
    abi.vendor = "Burin";
    abi.version = "1.0.0";
    abi.features = features_;
    abi.params = pointers_.data();
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  burin_brush_descriptor abi{};

 private:
  std::vector<burin_param_info> infos_;
  std::vector<const burin_param_info*> pointers_;
  const char* features_[2] = {"procedural", nullptr};
};

}  // namespace burin::test
