// Implements the host's service burin.stamps/1: checks arguments at the ABI, and samples open stamps.
#include <burin/abi/ext/log.h>
#include <burin/host/plugin/utf8_path.h>
#include <burin/services/service_tables.h>
#include <burin/stamp/area_filter.h>
#include <fmt/format.h>

#include <cmath>

namespace burin {
namespace {

burin_stamp_info info_of(const StampImage& image) {
  return {.struct_size = 0,
          .width = static_cast<std::uint32_t>(image.width),
          .height = static_cast<std::uint32_t>(image.height),
          .channels = static_cast<std::uint32_t>(image.channels),
          .minimum = image.minimum,
          .maximum = image.maximum,
          .wrap_u = static_cast<burin_stamp_wrap>(image.wrap_u),
          .wrap_v = static_cast<burin_stamp_wrap>(image.wrap_v)};
}

bool is_wrap(burin_stamp_wrap wrap) { return wrap >= BURIN_WRAP_UNKNOWN && wrap <= BURIN_WRAP_BLACK; }

burin_status BURIN_CALL open_with(const burin_host* host, const char* path,
                                  const burin_stamp_options* options, burin_stamp* stamp,
                                  burin_stamp_info* info, burin_text* error) {
  if (!path || !options || !stamp) return BURIN_INVALID_ARGUMENT;
  const burin_stamp_options known = known_members(*options);
  if (!is_wrap(known.wrap_u) || !is_wrap(known.wrap_v) || !std::isfinite(known.zero))
    return BURIN_INVALID_ARGUMENT;
  return status_of(error, [&] {
    StampStore& stamps = stamps_of(host);
    const auto [handle, filled] =
        stamps.open(path_from_utf8(path), {.wrap_u = static_cast<Wrap>(known.wrap_u),
                                           .wrap_v = static_cast<Wrap>(known.wrap_v),
                                           .clean = known.clean != 0,
                                           .layer = known.layer ? known.layer : "",
                                           .channel = known.channel ? known.channel : "",
                                           .zero = known.zero});
    if (filled > 0)
      services(host).write_log(
          BURIN_LOG_WARNING,
          fmt::format("{}: filled {} values that are not finite from their neighbours", path, filled));
    stamp->handle = handle;
    fill_known_members(info_of(stamps.find(handle)->stamp()), info);
  });
}

burin_status BURIN_CALL open_stamp(const burin_host* host, const char* path, burin_stamp* stamp,
                                   burin_stamp_info* info, burin_text* error) {
  constexpr burin_stamp_options none{
      sizeof none, BURIN_WRAP_UNKNOWN, BURIN_WRAP_UNKNOWN, 0, nullptr, nullptr, 0, 0};
  return open_with(host, path, &none, stamp, info, error);
}

void BURIN_CALL close_stamp(const burin_host* host, burin_stamp stamp) {
  stamps_of(host).close(stamp.handle);
}

float at(const burin_floats& floats, std::size_t i) { return floats.data[i * floats.stride]; }

/// Writes value(pyramid, i) for each i. Fails at the first NaN, which a position or area that is not finite
/// gives.
template <class Value>
burin_status sample_each(const burin_host* host, burin_stamp stamp, std::uint32_t channel,
                         std::uint32_t count, const burin_floats_out& values, const Value& value) {
  const MipPyramid* pyramid = stamps_of(host).find(stamp.handle);
  if (!pyramid) return BURIN_NOT_FOUND;
  if (channel >= static_cast<std::uint32_t>(pyramid->stamp().channels)) return BURIN_INVALID_ARGUMENT;
  for (std::size_t i = 0; i < count; ++i) {
    const float sample = value(*pyramid, i);
    if (std::isnan(sample)) return BURIN_INVALID_ARGUMENT;
    values.data[i * values.stride] = sample;
  }
  return BURIN_OK;
}

burin_status BURIN_CALL sample_stamp(const burin_host* host, burin_stamp stamp, std::uint32_t channel,
                                     std::uint32_t count, burin_floats u, burin_floats v,
                                     burin_floats_out values) {
  return sample_each(host, stamp, channel, count, values, [&](const MipPyramid& pyramid, std::size_t i) {
    return sample_bilinear(pyramid.stamp(), static_cast<int>(channel), at(u, i), at(v, i));
  });
}

burin_status BURIN_CALL sample_stamp_area(const burin_host* host, burin_stamp stamp, std::uint32_t channel,
                                          std::uint32_t count, burin_floats u, burin_floats v,
                                          const burin_stamp_area* area, burin_floats_out values) {
  if (!area) return BURIN_INVALID_ARGUMENT;
  return sample_each(host, stamp, channel, count, values, [&](const MipPyramid& pyramid, std::size_t i) {
    return sample_area(
        pyramid, static_cast<int>(channel), at(u, i), at(v, i),
        {at(area->along_u, i), at(area->along_v, i), at(area->across_u, i), at(area->across_v, i)});
  });
}

}  // namespace

constexpr burin_stamps stamps_service{sizeof(burin_stamps), 0,         open_stamp,       close_stamp,
                                      sample_stamp,         open_with, sample_stamp_area};

}  // namespace burin
