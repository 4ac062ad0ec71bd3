// Reads documents of Xournal and Xournal++. Positions are in points (1/72 inch) from the top left corner of
// their page. A stroke has one width, or one and then that of each segment, made from the pen's pressure: it
// tells pressure relative to the stroke only, and so stays a width.
#include <burin/base/error.h>
#include <burin/base/text/quoted_word.h>
#include <burin/ink/kinds/kinds.h>
#include <burin/ink/parse/scan.h>
#include <burin/ink/parse/xml.h>
#include <burin/ink/pen_file.h>
#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace burin {
namespace {

/// The text with points in its numbers, where Xournal wrote commas in some languages.
std::string with_points(std::string_view text) {
  std::string changed(text);
  std::ranges::replace(changed, ',', '.');
  return changed;
}

/// Reads numbers to the end of a text. Throws Error for anything else.
std::vector<double> numbers_in(std::string_view text) {
  std::vector<double> numbers;
  for (skip_blanks(text); !text.empty(); skip_blanks(text)) {
    double number = 0;
    if (!take_number(text, number))
      throw Error(fmt::format("expected a coordinate, found {}", quoted_word(text.substr(0, 20))));
    numbers.push_back(number);
  }
  return numbers;
}

/// The widths of a stroke, of which damaged files have some that are no numbers: what they had instead is
/// unknown, and the nominal width is taken.
std::vector<float> widths_of(std::string_view text, std::size_t points) {
  std::vector<float> widths;
  while (widths.size() < points) {
    std::string_view word = take_word(text);
    if (word.empty()) break;
    double width = 0;
    const bool good = take_number(word, width) && width > 0;
    widths.push_back(good || widths.empty() ? static_cast<float>(width) : widths.front());
  }
  // The first is the nominal one, the others belong to the segments that begin at each point but the last.
  if (widths.size() > 1) widths.erase(widths.begin());
  if (!widths.empty()) widths.resize(points, widths.back());
  return widths;
}

PenStroke stroke_of(const XmlFile& xml, const pugi::xml_node& node) try {
  std::string joined;
  std::string_view text = text_of(node, joined);
  if (text.find(',') != text.npos) text = joined = with_points(text);
  const std::vector<double> numbers = numbers_in(text);
  if (numbers.size() % 2 != 0) throw Error("a stroke with an x without y");
  PenStroke stroke;
  for (std::size_t i = 0; i < numbers.size(); i += 2)
    stroke.samples.push_back({.time = 0, .position = {numbers[i], numbers[i + 1], 0}, .pen = {}});
  stroke.widths = widths_of(with_points(attribute(node, "width").value()), stroke.samples.size());
  return stroke;
} catch (const FileError&) {
  throw;
} catch (const Error& error) {
  xml.reject(node, error.what());
}

/// Adds a stroke, or the name of another element that shows something: text, images, formulas, links.
void add_element(const XmlFile& xml, const pugi::xml_node& node, std::size_t page, std::size_t layer,
                 PenFile& content, std::set<std::string>& others) {
  constexpr std::string_view of_sound = "timestamp";
  constexpr std::size_t most_told = 20;
  const std::string_view name = node.name();
  if (node.type() == pugi::node_element && name != "stroke" && name != of_sound && others.size() < most_told)
    others.emplace(name);
  if (name != "stroke") return;
  PenStroke stroke = stroke_of(xml, node);
  if (stroke.samples.empty()) return;
  stroke.page = page;
  stroke.layer = layer;
  content.strokes.push_back(std::move(stroke));
}

}  // namespace

bool is_xournal(std::string_view text) { return begins_with_element(text, "xournal"); }

PenFile read_xournal(const PenFileText& file) {
  const XmlFile xml(file);
  PenFile content;
  content.unit = "pt";
  std::size_t page = 0;
  std::set<std::string> others;
  for (const pugi::xml_node& of_page : xml.root().children("page")) {
    ++page;
    std::size_t layer = 0;
    for (const pugi::xml_node& of_layer : of_page.children("layer")) {
      ++layer;
      for (const pugi::xml_node& node : of_layer.children())
        add_element(xml, node, page, layer, content, others);
    }
  }
  content.not_used.assign(others.begin(), others.end());
  return content;
}

}  // namespace burin
