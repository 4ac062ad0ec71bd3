#pragma once
#include <burin/abi/brush.h>

#include <array>
#include <cstddef>
#include <limits>

namespace burin::test {

/// The declaration of a brush with a parameter of every kind that matters to dynamics, and values of them.
struct VaryingBrush {
  VaryingBrush() {
    constexpr float infinite = std::numeric_limits<float>::infinity();
    const auto declare = [&](std::size_t i, const char* id, burin_param_type type, float low, float high,
                             bool dynamic) {
      infos[i].struct_size = sizeof(burin_param_info);
      infos[i].id = id;
      infos[i].type = type;
      infos[i].unit = BURIN_UNIT_NONE;
      infos[i].hard_min = low;
      infos[i].hard_max = high;
      infos[i].dynamic = dynamic;
      pointers[i] = &infos[i];
      values[i].number = {&numbers[i], 0, 0};
    };
    declare(0, "size", BURIN_PARAM_FLOAT, 0.125F, 4, true);
    declare(1, "turn", BURIN_PARAM_FLOAT, -3, 3, true);
    infos[1].unit = BURIN_UNIT_ANGLE;
    declare(2, "count", BURIN_PARAM_INT, 1, 9, true);
    declare(3, "flip", BURIN_PARAM_BOOL, 0, 0, true);
    declare(4, "endless", BURIN_PARAM_FLOAT, -infinite, infinite, true);
    declare(5, "fixed", BURIN_PARAM_FLOAT, 0, 1, false);
    declare(6, "picture", BURIN_PARAM_FILE, 0, 0, true);
    declare(7, "tint", BURIN_PARAM_COLOUR, 0, 0, true);
    declare(8, "mode", BURIN_PARAM_CHOICE, 0, 0, true);
    descriptor.struct_size = sizeof(descriptor);
    descriptor.id = "org.burin.test.varying";
    descriptor.param_count = static_cast<std::uint32_t>(count);
    descriptor.params = pointers.data();
    params = {sizeof(burin_params), descriptor.param_count, values.data()};
  }
  VaryingBrush(const VaryingBrush&) = delete;
  VaryingBrush& operator=(const VaryingBrush&) = delete;

  static constexpr std::size_t count = 9;
  std::array<burin_param_info, count> infos{};
  std::array<const burin_param_info*, count> pointers{};
  std::array<float, count> numbers{2, 0.5F, 7, 1, 2, 0.5F, 0, 0, 0};
  std::array<burin_param_value, count> values{};
  burin_brush_descriptor descriptor{};
  burin_params params{};
};

}  // namespace burin::test
