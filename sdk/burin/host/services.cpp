#include <burin/abi/ext/log.h>
#include <burin/abi/ext/stamps.h>
#include <burin/base/error.h>
#include <burin/host/services.h>
#include <burin/host/utf8_path.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>

namespace burin {
namespace {

HostServices& services(const burin_host* host) { return *static_cast<HostServices*>(host->self); }

void copy_text(std::string_view line, burin_text* text) {
  if (!text || text->capacity == 0) return;
  const std::size_t size = std::min<std::size_t>(line.size(), text->capacity - 1);
  std::memcpy(text->data, line.data(), size);
  text->data[size] = '\0';
}

void BURIN_CALL write_log_line(const burin_host* host, burin_log_severity severity, const char* line) {
  if (line) services(host).write_log(severity, line);
}

/// Fills the members of *info that the caller's version has.
void describe(const StampImage& image, burin_stamp_info* info) {
  if (!info) return;
  burin_stamp_info full{};
  full.struct_size = info->struct_size;
  full.width = static_cast<std::uint32_t>(image.width);
  full.height = static_cast<std::uint32_t>(image.height);
  full.channels = static_cast<std::uint32_t>(image.channels);
  full.minimum = image.minimum;
  full.maximum = image.maximum;
  full.wrap_u = full.wrap_v = BURIN_WRAP_PERIODIC;
  std::memcpy(info, &full, std::min<std::size_t>(info->struct_size, sizeof(full)));
}

burin_status BURIN_CALL open_stamp(const burin_host* host, const char* path, burin_stamp* stamp,
                                   burin_stamp_info* info, burin_text* error) {
  if (!path || !stamp) return BURIN_INVALID_ARGUMENT;
  try {
    StampStore& stamps = services(host).stamps();
    stamp->handle = stamps.open(path_from_utf8(path));
    describe(*stamps.find(stamp->handle), info);
    return BURIN_OK;
  } catch (const std::exception& failure) {
    copy_text(failure.what(), error);
    return BURIN_ERROR;
  }
}

void BURIN_CALL close_stamp(const burin_host* host, burin_stamp stamp) {
  services(host).stamps().close(stamp.handle);
}

burin_status BURIN_CALL sample_stamp(const burin_host* host, burin_stamp stamp, std::uint32_t channel,
                                     std::uint32_t count, burin_floats u, burin_floats v,
                                     burin_floats_out values) {
  const StampImage* image = services(host).stamps().find(stamp.handle);
  if (!image) return BURIN_NOT_FOUND;
  if (channel >= static_cast<std::uint32_t>(image->channels)) return BURIN_INVALID_ARGUMENT;
  for (std::size_t i = 0; i < count; ++i) {
    const float x = u.data[i * u.stride], y = v.data[i * v.stride];
    if (!std::isfinite(x) || !std::isfinite(y)) return BURIN_INVALID_ARGUMENT;
    values.data[i * values.stride] = sample_bilinear(*image, static_cast<int>(channel), x, y);
  }
  return BURIN_OK;
}

burin_status BURIN_CALL open_with(const burin_host* host, const char* path,
                                  const burin_stamp_options* options, burin_stamp* stamp,
                                  burin_stamp_info* info, burin_text* error) {
  const auto offered = [](burin_stamp_wrap wrap) { return wrap <= BURIN_WRAP_PERIODIC; };
  if (!offered(options->wrap_u) || !offered(options->wrap_v) || options->clean) {
    copy_text("this host repeats stamps and does not clean them", error);
    return BURIN_UNSUPPORTED;
  }
  return open_stamp(host, path, stamp, info, error);
}

burin_status BURIN_CALL sample_area(const burin_host* host, burin_stamp stamp, std::uint32_t channel,
                                    std::uint32_t count, burin_floats u, burin_floats v,
                                    const burin_stamp_area*, burin_floats_out values) {
  return sample_stamp(host, stamp, channel, count, u, v, values);
}

constexpr burin_log log_service{sizeof(burin_log), 0, write_log_line};
constexpr burin_stamps stamps_service{sizeof(burin_stamps), 0,         open_stamp, close_stamp,
                                      sample_stamp,         open_with, sample_area};

const void* BURIN_CALL get_extension(const burin_host*, const char* id) {
  if (!id) return nullptr;
  if (std::strcmp(id, BURIN_EXT_LOG) == 0) return &log_service;
  if (std::strcmp(id, BURIN_EXT_STAMPS) == 0) return &stamps_service;
  return nullptr;
}

}  // namespace

HostServices::HostServices(Log log)
    : log_(log),
      host_{.struct_size = sizeof(burin_host),
            .abi_major = BURIN_ABI_MAJOR,
            .abi_minor = BURIN_ABI_MINOR,
            .reserved = 0,
            .self = this,
            .name = "Burin",
            .version = BURIN_VERSION,
            .get_extension = get_extension} {}

void HostServices::write_log(int severity, std::string_view line) const {
  if (log_) log_(severity, line);
}

}  // namespace burin
