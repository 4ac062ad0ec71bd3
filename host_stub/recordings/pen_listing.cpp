// Lists pages, layers and strokes of a pen file in one pass over its strokes.
#include "recordings/pen_listing.h"

#include <burin/base/text/quoted_word.h>
#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

namespace burin::command {
namespace {

/// What the stroke has beside positions.
std::vector<std::string> fields_of(const PenStroke& stroke) {
  std::vector<std::string> fields;
  if (stroke.fields.time) fields.emplace_back("time");
  if (stroke.fields.pressure) fields.emplace_back(stroke.made_pressure ? "made pressure" : "pressure");
  if (stroke.fields.tilt) fields.emplace_back("tilt");
  if (stroke.fields.twist) fields.emplace_back("twist");
  if (stroke.fields.barrel) fields.emplace_back("barrel");
  if (stroke.has_z) fields.emplace_back("z");
  if (!stroke.widths.empty()) fields.emplace_back("width");
  return fields;
}

/// As plain as it is, if it is a word of letters.
std::string shown(const std::string& tool) {
  const bool plain = tool.size() < 16 && tool.find_first_not_of("abcdefghijklmnopqrstuvwxyz") == tool.npos;
  return plain ? tool : quoted_word(tool);
}

/// Seconds from the first sample to the last.
double duration(const PenStroke& stroke) {
  if (!stroke.fields.time || stroke.samples.empty()) return 0;
  return stroke.samples.back().time - stroke.samples.front().time;
}

std::string line_of(std::size_t number, const PenStroke& stroke) {
  std::string line = fmt::format("    stroke {}: {} samples", number, stroke.samples.size());
  if (!stroke.drawn_by.tool.empty()) line += fmt::format(", {}", shown(stroke.drawn_by.tool));
  if (stroke.drawn_by.eraser) line += ", eraser";
  if (stroke.fields.time) line += fmt::format(", {:.3f} s", duration(stroke));
  for (const std::string& field : fields_of(stroke))
    if (field != "time") line += ", " + field;
  return line + '\n';
}

}  // namespace

std::string listing_text(const PenFile& file) {
  std::map<std::size_t, std::map<std::size_t, std::string>> pages;  // [page][layer] lines of strokes
  for (std::size_t i = 0; i < file.strokes.size(); ++i)
    pages[file.strokes[i].page][file.strokes[i].layer] += line_of(i + 1, file.strokes[i]);
  std::string text;
  for (const auto& [page, layers] : pages) {
    text += fmt::format("page {}\n", page);
    for (const auto& [layer, lines] : layers) text += fmt::format("  layer {}\n{}", layer, lines);
  }
  return text;
}

Json listing_json(const PenFile& file) {
  Json list = Json::array();
  for (std::size_t i = 0; i < file.strokes.size(); ++i) {
    const PenStroke& stroke = file.strokes[i];
    list.push_back({{"stroke", i + 1},
                    {"page", stroke.page},
                    {"layer", stroke.layer},
                    {"samples", stroke.samples.size()},
                    {"tool", stroke.drawn_by.tool},
                    {"eraser", stroke.drawn_by.eraser},
                    {"seconds", stroke.fields.time ? Json(duration(stroke)) : Json(nullptr)},
                    {"fields", fields_of(stroke)}});
  }
  return list;
}

}  // namespace burin::command
