// Parses XML by pugixml, which knows no entities but the five of XML.
#include <burin/base/error.h>
#include <burin/ink/parse/scan.h>
#include <burin/ink/parse/xml.h>
#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace burin {
namespace {

/// Most of the characters that begin tags, or values of attributes, in a text of this size. Handwriting has
/// fewer: each of them takes memory of its own.
std::ptrdiff_t most_marks(std::size_t bytes) {
  constexpr std::size_t always = 500'000, bytes_a_mark = 32;
  return static_cast<std::ptrdiff_t>(std::max(always, bytes / bytes_a_mark));
}

constexpr int deepest_xml = 200;

/// An element deeper than that, or an empty one.
pugi::xml_node too_deep(const pugi::xml_node& root) {
  struct Walker : pugi::xml_tree_walker {
    pugi::xml_node found;
    bool for_each(pugi::xml_node& node) override {
      if (depth() >= deepest_xml) found = node;
      return !found;
    }
  } walker;
  pugi::xml_node from = root;
  from.traverse(walker);
  return walker.found;
}

}  // namespace

XmlFile::XmlFile(const PenFileText& file) : file_(file) {
  const std::ptrdiff_t most = most_marks(file.text.size());
  for (const auto& [mark, what] : {std::pair('<', "tags"), std::pair('=', "attributes")})
    if (std::ranges::count(file.text, mark) > most)
      throw FileError(file.path.string(), fmt::format("more than {} {} of XML", most, what));
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

namespace {

/// The bytes of the comment, instruction or declaration at the front of a text; npos if it does not end.
/// Declarations of the document's type may have others in brackets.
std::size_t length_of_prolog(std::string_view text) {
  const auto behind = [&](std::string_view end, std::size_t from) {
    const std::size_t at = text.find(end, from);
    return at == text.npos ? text.size() : at + end.size();
  };
  if (text.starts_with("<?")) return text.find("?>") == text.npos ? text.npos : behind("?>", 0);
  bool in_brackets = false;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c == '>' && !in_brackets) return at + 1;
    if (c == '[' || c == ']') in_brackets = c == '[';
    const bool quote = c == '"' || c == '\'';
    if (text.substr(at).starts_with("<!--")) {
      at = behind("-->", at);
      if (text.starts_with("<!--")) return at;
    } else {
      at = quote ? behind(text.substr(at, 1), at + 1) : at + 1;
    }
  }
  return text.npos;
}

}  // namespace

bool begins_with_element(std::string_view text, std::string_view name) {
  for (;;) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    if (text.starts_with("<?") || text.starts_with("<!")) {
      const std::size_t length = length_of_prolog(text);
      if (length == text.npos) return false;
      text.remove_prefix(length);
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

std::optional<double> number_of(const pugi::xml_attribute& attribute) {
  std::string_view text = attribute.value();
  double value = 0;
  return take_number(text, value) ? std::optional(value) : std::nullopt;
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
