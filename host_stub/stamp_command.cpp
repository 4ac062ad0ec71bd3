// The command `burin stamp`: describes an image as brushes read it, measures whether it tiles, and draws a
// preview.
#include <burin/base/text/quoted_word.h>
#include <burin/stamp/files/stamp_file.h>
#include <burin/stamp/seam.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.h"
#include "pictures/stamp_preview.h"
#include "system/console.h"
#include "system/output_file.h"

namespace burin::command {
namespace {

struct StampCommandOptions {
  std::string path, preview;
  StampOptions read;
  bool json = false;
};

/// Parses "MODE" or "MODE,MODE".
void read_wrap(const std::string& text, StampOptions& options) {
  std::tie(options.wrap_u, options.wrap_v) = parse_wraps(text);
  if (options.wrap_u == Wrap::unknown || options.wrap_v == Wrap::unknown)
    throw CLI::ValidationError("--wrap", quoted_word(text) +
                                             " is none of periodic, mirror, clamp and black, or two of "
                                             "them for u and v: mirror,clamp");
}

bool is_cropped(const StampImage& image, const StampFile& file) {
  const bool exchanged = file.orientation >= 5 && file.orientation <= 8;
  const int width = exchanged ? image.height : image.width, height = exchanged ? image.width : image.height;
  return file.data_x != 0 || file.data_y != 0 || file.data_width != width || file.data_height != height;
}

Json stamp_json(const std::string& path, const StampImage& image, const StampFile& file, const Seam& seam) {
  Json channels = Json::array();
  for (int c = 0; c < image.channels; ++c) {
    const auto [least, greatest] = channel_range(image, c);
    channels.push_back({{"name", file.channels[static_cast<std::size_t>(c)]}, {"range", {least, greatest}}});
  }
  Json json = {{"file", path},
               {"width", image.width},
               {"height", image.height},
               {"channels", channels},
               {"texels", file.texel_type},
               {"format", file.format},
               {"compression", file.compression.empty() ? Json() : Json(file.compression)},
               {"tile", file.tile_width ? Json{file.tile_width, file.tile_height} : Json()},
               {"mip_levels", file.mip_levels},
               {"unused_channels", file.unused},
               {"orientation", file.orientation},
               {"wrap", {wrap_name(image.wrap_u), wrap_name(image.wrap_v)}},
               {"wrap_of_file", {wrap_name(file.wrap_u), wrap_name(file.wrap_v)}},
               {"not_finite", file.not_finite}};
  if (is_cropped(image, file))
    json["data_window"] = {file.data_x, file.data_y, file.data_width, file.data_height};
  json["seam"] = {{"x", seam.x.over_interior},           {"y", seam.y.over_interior},
                  {"x_beside", seam.x.over_beside},      {"y_beside", seam.y.over_beside},
                  {"border_spread", seam.border_spread}, {"verdict", verdict_name(seam.verdict)}};
  return json;
}

std::string channel_text(const StampImage& image, const StampFile& file) {
  std::string text;
  for (int c = 0; c < image.channels; ++c) {
    const auto [least, greatest] = channel_range(image, c);
    text += fmt::format("{}{} {:.6g} .. {:.6g}", c ? ", " : "",
                        printable(file.channels[static_cast<std::size_t>(c)]), least, greatest);
  }
  return text;
}

std::string unused_text(const StampFile& file) {
  constexpr std::size_t most = 12;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, file.unused.size()); ++i)
    text += (i ? ", " : "") + printable(file.unused[i]);
  return file.unused.size() <= most ? text : fmt::format("{} and {} more", text, file.unused.size() - most);
}

std::string verdict_text(SeamVerdict verdict) {
  switch (verdict) {
    case SeamVerdict::tiles:
      return "tiles";
    case SeamVerdict::does_not_tile:
      return "does not tile: repeated, it shows its borders";
    default:
      return "padded: a single motif on even ground";
  }
}

void print_text(const std::string& path, const StampImage& image, const StampFile& file, const Seam& seam) {
  write_result(
      fmt::format("{}: {} x {}, {} channel{} of {} texels, {}{}{}{}\n", path, image.width, image.height,
                  image.channels, image.channels == 1 ? "" : "s", file.texel_type, file.format,
                  file.compression.empty() ? "" : ", compression " + file.compression,
                  file.tile_width ? fmt::format(", tiles of {} x {}", file.tile_width, file.tile_height) : "",
                  file.mip_levels > 1 ? fmt::format(", {} mip levels", file.mip_levels) : ""));
  if (is_cropped(image, file))
    write_result(fmt::format("  data only in {} x {} texels from ({}, {}), 0 elsewhere\n", file.data_width,
                             file.data_height, file.data_x, file.data_y));
  write_result(fmt::format("  range {}\n", channel_text(image, file)));
  if (!file.unused.empty()) write_result(fmt::format("  not used: {}\n", unused_text(file)));
  if (file.orientation > 1 && file.orientation <= 8)
    write_result(fmt::format("  turned upright, from orientation {}\n", file.orientation));
  write_result(fmt::format(
      "  wrap {}, {}{}\n", wrap_name(image.wrap_u), wrap_name(image.wrap_v),
      file.wrap_u == Wrap::unknown
          ? ""
          : fmt::format(" (in the file {}, {})", wrap_name(file.wrap_u), wrap_name(file.wrap_v))));
  write_result(fmt::format(
      "  seam {:.2f} / {:.2f} of the mean step (x / y), {:.2f} / {:.2f} of the steps beside it: {}\n",
      seam.x.over_interior, seam.y.over_interior, seam.x.over_beside, seam.y.over_beside,
      verdict_text(seam.verdict)));
}

void run(const StampCommandOptions& options) {
  check_output_path(options.preview);
  StampFile file;
  const StampImage image = read_stamp(options.path, options.read, &file);
  const Seam seam = measure_seam(image);
  if (!options.preview.empty()) write_png(options.preview, stamp_preview(make_mip_pyramid(image)));
  if (file.not_finite > 0)
    warn(fmt::format("{}: filled {} values that are not finite from their neighbours", options.path,
                     file.not_finite));
  if (options.json)
    write_result(json_text(stamp_json(options.path, image, file, seam)));
  else
    print_text(options.path, image, file, seam);
}

}  // namespace

void add_stamp(CLI::App& app) {
  const auto options = std::make_shared<StampCommandOptions>();
  CLI::App& command = *app.add_subcommand("stamp", "say what an image is as a stamp, and whether it tiles");
  command.add_option("image", options->path, "EXR, TIFF, PNG or JPEG image")->required()->type_name("FILE");
  command
      .add_option_function<std::string>(
          "--wrap", [options](const std::string& text) { read_wrap(text, options->read); },
          "beyond the borders, in u and v: periodic, mirror, clamp or black, instead of what the file says")
      ->type_name("MODE[,MODE]");
  command.add_option("--layer", options->read.layer, "whose channels count, of an EXR image with several")
      ->type_name("NAME");
  command
      .add_option("--channel", options->read.channel,
                  "channel to take, or three between commas, instead of those that names tell")
      ->type_name("NAME[,NAME,NAME]");
  command.add_flag("--clean", options->read.clean,
                   "fill texels that are not finite instead of refusing them");
  command
      .add_option(
          "--preview", options->preview,
          "PNG to write: three by three stamps; least value black, greatest white, even steps between")
      ->type_name("FILE");
  command.add_flag("--json", options->json, "write JSON to the standard output");
  command.callback([options] { run(*options); });
}

}  // namespace burin::command
