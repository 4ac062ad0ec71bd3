// Parses XML by pugixml, which knows no entities but the five of XML.
#include <burin/base/error.h>
#include <burin/ink/parse/xml.h>
#include <fmt/format.h>

#include <algorithm>

namespace burin {
namespace {

constexpr std::ptrdiff_t most_tags = 500'000, most_attributes = 500'000;
constexpr int deepest = 200;

/// An element deeper than that, or an empty one.
pugi::xml_node too_deep(const pugi::xml_node& root) {
  struct Walker : pugi::xml_tree_walker {
    pugi::xml_node found;
    bool for_each(pugi::xml_node& node) override {
      if (depth() >= deepest) found = node;
      return !found;
    }
  } walker;
  pugi::xml_node from = root;
  from.traverse(walker);
  return walker.found;
}

}  // namespace

XmlFile::XmlFile(const PenFileText& file) : file_(file) {
  if (std::ranges::count(file.text, '<') > most_tags)
    throw FileError(file.path.string(), "more than 500,000 tags of XML");
  if (std::ranges::count(file.text, '=') > most_attributes)
    throw FileError(file.path.string(), "more than 500,000 attributes of XML");
  const pugi::xml_parse_result result = document_.load_buffer(file.text.data(), file.text.size());
  if (!result)
    throw FileError(file.path.string(), place(result.offset),
                    fmt::format("malformed XML: {}", result.description()));
  if (const pugi::xml_node node = too_deep(root())) reject(node, "nested deeper than 200 elements");
}

void XmlFile::reject(const pugi::xml_node& node, std::string_view what) const {
  throw FileError(file_.path.string(), place(node.offset_debug()), what);
}

/// The line, from 1, of a place in the text.
std::string XmlFile::place(std::ptrdiff_t offset) const {
  const auto end = std::clamp<std::ptrdiff_t>(offset, 0, static_cast<std::ptrdiff_t>(file_.text.size()));
  return std::to_string(1 + std::count(file_.text.begin(), file_.text.begin() + end, '\n'));
}

bool begins_with_element(std::string_view text, std::string_view name) {
  for (;;) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    if (text.starts_with("<?") || text.starts_with("<!")) {
      const std::string_view end = text.starts_with("<!--") ? "-->" : ">";
      const std::size_t at = text.find(end);
      if (at == text.npos) return false;
      text.remove_prefix(at + end.size());
      continue;
    }
    if (!text.starts_with('<')) return false;
    const std::string element(text.substr(1, text.find_first_of(" \t\r\n/>") - 1));
    return local_name(element.c_str()) == name;
  }
}

std::string_view local_name(const char* name) {
  const std::string_view whole = name;
  const std::size_t colon = whole.find(':');
  return colon == whole.npos ? whole : whole.substr(colon + 1);
}

pugi::xml_attribute attribute(const pugi::xml_node& node, std::string_view name) {
  return node.find_attribute([&](const pugi::xml_attribute& one) { return local_name(one.name()) == name; });
}

std::string_view text_of(const pugi::xml_node& node, std::string& joined) {
  const auto is_text = [](const pugi::xml_node& one) {
    return one.type() == pugi::node_pcdata || one.type() == pugi::node_cdata;
  };
  const auto texts = node.children();
  if (std::ranges::count_if(texts, is_text) <= 1) return node.text().get();
  joined.clear();
  for (const pugi::xml_node& one : texts)
    if (is_text(one)) joined.append(one.value()).append(" ");
  return joined;
}

pugi::xml_node child(const pugi::xml_node& node, std::string_view name) {
  return node.find_child([&](const pugi::xml_node& one) { return local_name(one.name()) == name; });
}

}  // namespace burin
