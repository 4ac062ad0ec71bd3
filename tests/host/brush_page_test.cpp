// Checks that docs/brushes.md matches the descriptors of the brushes.
#include <burin/abi/plugin.h>
#include <burin/base/file.h>
#include <burin/deform/evaluate/supported_inputs.h>
#include <burin/deform/overlap.h>
#include <fmt/format.h>

#include <cmath>

#include "sessions.h"

namespace burin {
namespace {

namespace fs = std::filesystem;

const fs::path docs = fs::path(BURIN_SAMPLES).parent_path() / "docs";

std::string unit_of(const burin_param_info& param) {
  switch (param.unit) {
    case BURIN_UNIT_RADIUS:
      return " radii";
    case BURIN_UNIT_ANGLE:
      return " rad";
    case BURIN_UNIT_TIME:
      return " s";
    default:
      return "";
  }
}

std::string choices_of(const burin_param_info& param) {
  std::string choices;
  for (const char* const* choice = param.choices; *choice; ++choice)
    choices += fmt::format("{}`{}`", choices.empty() ? "" : ", ", *choice);
  return choices;
}

std::string range_of(const burin_param_info& param) {
  switch (param.type) {
    case BURIN_PARAM_FLOAT:
    case BURIN_PARAM_INT:
      return fmt::format("{:g} .. {:g}{}", param.hard_min, param.hard_max, unit_of(param));
    case BURIN_PARAM_CHOICE:
      return choices_of(param);
    case BURIN_PARAM_BOOL:
      return "`true`, `false`";
    case BURIN_PARAM_COLOUR:
      return "red, green, blue, alpha";
    case BURIN_PARAM_CURVE:
      return "a curve";
    case BURIN_PARAM_FILE:
      return "a file";
    default:
      return "a text";
  }
}

std::string default_of(const burin_param_info& param) {
  const auto quoted = [](const char* text) { return text && *text ? fmt::format("`{}`", text) : ""; };
  switch (param.type) {
    case BURIN_PARAM_FLOAT:
    case BURIN_PARAM_INT:
      return fmt::format("{:g}", param.default_number);
    case BURIN_PARAM_CHOICE:
      return quoted(param.choices[static_cast<int>(param.default_number)]);
    case BURIN_PARAM_BOOL:
      return param.default_number != 0 ? "`true`" : "`false`";
    case BURIN_PARAM_COLOUR:
      return fmt::format("{:g}", fmt::join(param.default_colour, ", "));
    case BURIN_PARAM_FILE:
      return quoted(param.default_file);
    case BURIN_PARAM_TEXT:
      return quoted(param.default_text);
    default:
      return "";
  }
}

std::string section(const BrushEntry& entry) {
  const burin_brush_descriptor& brush = *entry.descriptor;
  std::string text = fmt::format("\n## {0}\n\n![{0}](../samples/gallery/{1}.png)\n\n{2}\n\n", brush.name,
                                 entry.module.stem().string(), brush.help);
  text += brush.outputs_written == 0 ? std::string("Makes a solid, see [solids.md](solids.md).\n\n")
                                     : fmt::format("Where a stroke overlaps itself: `{}`.\n\n",
                                                   name_of(named_overlaps, overlap_of(brush)));
  text += fmt::format("| `{}` | values | default | |\n|---|---|---|---|\n", brush.id);
  for (std::uint32_t i = 0; i < brush.param_count; ++i) {
    const burin_param_info& param = *brush.params[i];
    text += fmt::format("| `{}` | {} | {} | {} |\n", param.id, range_of(param), default_of(param),
                        param.help ? param.help : "");
  }
  return text;
}

std::string page() {
  std::string text =
      "# The stock brushes\n\n"
      "Lengths in radii are multiples of half the width of the stroke. [overlap.md](overlap.md) tells what\n"
      "the brushes do where a stroke overlaps itself.<!-- sources --> Each is one source in `brushes/`;\n"
      "`./dev gallery` draws the pictures.<!-- /sources -->\n";
  BrushLibrary library;
  library.load_folder(test::brushes_folder);
  for (const BrushEntry& brush : library.brushes()) text += section(brush);
  return text;
}

TEST(BrushPage, IsWhatTheBrushesSay) {
  const std::string expected = page();
  if (read_file(docs / "brushes.md") == expected) return;
  const fs::path written = fs::temp_directory_path() / "burin-brushes.md";
  write_file_whole(written, [&](std::ostream& out) { out << expected; });
  ADD_FAILURE() << "docs/brushes.md is out of date: copy " << written.string() << " over it";
}

TEST(BrushPage, HasAPictureOfEachBrush) {
  for (const BrushEntry& brush : test::brushes().brushes()) {
    if (brush.module.parent_path() != test::brushes_folder) continue;
    if (brush.descriptor->inputs_read & ~supported_inputs ||
        brush.descriptor->outputs_written & ~supported_outputs)
      continue;
    const fs::path picture = fs::path(BURIN_SAMPLES) / "gallery" / (brush.module.stem().string() + ".png");
    ASSERT_TRUE(fs::is_regular_file(picture)) << picture << ": ./dev gallery draws it";
    EXPECT_LT(fs::file_size(picture), 200'000u) << picture;
  }
}

}  // namespace
}  // namespace burin
