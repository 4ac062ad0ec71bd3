// Parameters and curves as messages.
#include <burin/host/isolate/stroke_message.h>

#include <cstdint>

namespace burin::isolate {
namespace {

float first_of(const burin_floats& array) { return array.data ? array.data[0] : 0; }

void write_floats(MessageWriter& to, const float* data, std::size_t count) {
  to.block(std::as_bytes(std::span(data, data ? count : 0)));
}

std::vector<float> read_floats(MessageReader& from) {
  const std::span<const std::byte> bytes = from.block();
  std::vector<float> floats(bytes.size() / sizeof(float));
  if (!floats.empty()) std::memcpy(floats.data(), bytes.data(), floats.size() * sizeof(float));
  return floats;
}

std::array<burin_floats, 10> columns_of(const burin_curve_points& points) {
  const burin_vectors &p = points.position, &n = points.normal, &e = points.e1;
  return {points.t, p.x, p.y, p.z, n.x, n.y, n.z, e.x, e.y, e.z};
}

}  // namespace

void write_params(MessageWriter& to, const burin_params& params) {
  to.value(params.count);
  for (std::uint32_t i = 0; i < params.count; ++i) {
    const burin_param_value& value = params.values[i];
    std::array<float, 5> numbers{first_of(value.number)};
    for (std::size_t k = 0; k < 4; ++k) numbers[k + 1] = first_of(value.colour[k]);
    const std::uint32_t has_text = value.text != nullptr;
    to.value(numbers).value(has_text).text(has_text ? value.text : "");
    write_floats(to, value.knots, 2 * std::size_t{value.knot_count});
  }
}

ReceivedParams::ReceivedParams(MessageReader& from) {
  const std::uint32_t count = from.count(sizeof(std::array<float, 5>));
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto& numbers = numbers_.emplace_back(from.value<std::array<float, 5>>());
    burin_param_value value{};
    value.number = {numbers.data(), 0, 0};
    for (std::size_t k = 0; k < 4; ++k) value.colour[k] = {&numbers[k + 1], 0, 0};
    const bool has_text = from.value<std::uint32_t>() != 0;
    const std::string& text = texts_.emplace_back(from.text());
    if (has_text) value.text = text.c_str();
    const std::vector<float>& knots = knots_.emplace_back(read_floats(from));
    if (!knots.empty()) value.knots = knots.data();
    value.knot_count = static_cast<std::uint32_t>(knots.size() / 2);
    values_.push_back(value);
  }
  params_ = {sizeof(burin_params), count, values_.data()};
}

void write_points(MessageWriter& to, const burin_curve_points& points) {
  to.value(points.count);
  std::vector<float> column(points.count);
  for (const burin_floats& array : columns_of(points)) {
    for (std::size_t i = 0; i < column.size(); ++i) column[i] = array.data[i * array.stride];
    write_floats(to, column.data(), column.size());
  }
}

ReceivedPoints::ReceivedPoints(MessageReader& from) {
  points_.struct_size = sizeof points_;
  points_.count = from.value<std::uint32_t>();
  for (std::vector<float>& column : columns_) {
    column = read_floats(from);
    column.resize(points_.count);
  }
  const auto at = [&](std::size_t i) { return burin_floats{columns_[i].data(), 1, 0}; };
  points_.t = at(0);
  points_.position = {at(1), at(2), at(3)};
  points_.normal = {at(4), at(5), at(6)};
  points_.e1 = {at(7), at(8), at(9)};
}

}  // namespace burin::isolate
