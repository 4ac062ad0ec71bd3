// Reads the style sheets of SVG pictures, as Illustrator writes them: hidden layers have a class whose rule
// says "display:none".
#include <burin/base/error.h>
#include <burin/ink/parse/scan.h>
#include <burin/ink/parse/svg_styles.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace burin {
namespace {

/// Removes the text up to `mark` from the front of a text, and the mark, and returns it without blanks.
std::string_view take_to(std::string_view& text, char mark) {
  std::string_view part = text.substr(0, text.find(mark));
  text.remove_prefix(std::min(part.size() + 1, text.size()));
  skip_blanks(part);
  return part.substr(0, part.find_last_not_of(blanks) + 1);
}

std::string without_comments(std::string_view text) {
  std::string plain;
  for (;;) {
    const std::size_t begin = text.find("/*");
    plain.append(text.substr(0, begin));
    const std::size_t end = begin == text.npos ? begin : text.find("*/", begin + 2);
    if (end == text.npos) return plain;
    plain += ' ';
    text.remove_prefix(end + 2);
  }
}

/// Of a rule's declarations those that are read.
std::string declarations_of(std::string_view block) {
  constexpr std::array<std::string_view, 4> read = {"display", "visibility", "transform", "transform-origin"};
  std::string declarations;
  while (!block.empty()) {
    const std::string_view one = take_to(block, ';');
    std::string_view rest = one;
    if (std::ranges::find(read, take_to(rest, ':')) != read.end()) declarations.append(one).append(";");
  }
  return declarations;
}

/// Adds what is to be done or kept to the sum so far. Throws Error for more than pictures need.
void charge(std::size_t& sum, std::size_t more) {
  constexpr std::size_t most = 20'000'000;
  sum += more;
  if (sum > most) throw Error("style sheets that say more than pictures need");
}

/// What a selector needs of an element; an id or else a name and a class, of which one may be empty.
struct Rule {
  std::string name, of_class, id, declarations;

  /// Of two rules for an element that which weighs more counts, else the later one.
  int weight() const { return id.empty() ? (of_class.empty() ? 0 : 1) + (name.empty() ? 0 : 1) : 3; }
};

bool is_simple(std::string_view selector) {
  return !selector.empty() && selector.find_first_of(" \t\r\n>+~:[*") == selector.npos;
}

Rule rule_of(std::string_view selector, const std::string& declarations) {
  Rule rule{.name = {}, .of_class = {}, .id = {}, .declarations = declarations};
  if (selector.starts_with('#')) {
    rule.id = selector.substr(1);
    return rule;
  }
  const std::size_t dot = selector.find('.');
  rule.name = selector.substr(0, dot);
  if (dot != selector.npos) rule.of_class = selector.substr(dot + 1);
  return rule;
}

/// Removes a rule that begins with "@" from the front of a sheet: up to a semicolon, or with its block.
void skip_at_rule(std::string_view& sheet) {
  std::size_t open = 0, at = 0;
  for (; at < sheet.size(); ++at) {
    if (sheet[at] == '{') ++open;
    if (sheet[at] == '}' && open > 0) --open;
    if (open == 0 && (sheet[at] == ';' || sheet[at] == '}')) break;
  }
  sheet.remove_prefix(std::min(at + 1, sheet.size()));
}

/// Adds the rules of a sheet that say anything which is read, but not those for some media only. `kept`:
/// bytes of rules so far.
void add_rules(std::string_view sheet, std::vector<Rule>& rules, std::size_t& kept) {
  for (skip_blanks(sheet); !sheet.empty(); skip_blanks(sheet)) {
    if (sheet.starts_with('@')) {
      skip_at_rule(sheet);
      continue;
    }
    std::string_view selectors = take_to(sheet, '{');
    const std::string declarations = declarations_of(take_to(sheet, '}'));
    while (!declarations.empty() && !selectors.empty()) {
      const std::string_view one = take_to(selectors, ',');
      if (!is_simple(one)) continue;
      charge(kept, sizeof(Rule) + one.size() + declarations.size());
      rules.push_back(rule_of(one, declarations));
    }
  }
}

class StyledElements : public pugi::xml_tree_walker {
 public:
  explicit StyledElements(std::vector<Rule> rules) : rules_(std::move(rules)) {
    std::ranges::stable_sort(rules_, {}, &Rule::weight);
  }

  bool for_each(pugi::xml_node& node) override {
    if (node.type() == pugi::node_element) style(node);
    return true;
  }

 private:
  void style(pugi::xml_node& node) {
    constexpr std::size_t letters_a_rule = 8;  // take as long as a rule
    const std::size_t letters = std::string_view(node.attribute("class").value()).size();
    charge(compared_, rules_.size() * (1 + letters / letters_a_rule));
    std::string style;
    for (const Rule& rule : rules_)
      if (fits(rule, node)) style += rule.declarations;
    charge(added_, style.size());
    if (style.empty()) return;
    pugi::xml_attribute own = node.attribute("style");
    if (!own) own = node.append_attribute("style");
    own.set_value((style + own.value()).c_str());
  }

  static bool fits(const Rule& rule, const pugi::xml_node& node) {
    if (!rule.id.empty()) return rule.id == node.attribute("id").value();
    if (!rule.name.empty() && rule.name != local_name(node.name())) return false;
    if (rule.of_class.empty()) return !rule.name.empty();
    for (std::string_view rest = node.attribute("class").value(); !rest.empty();)
      if (take_word(rest) == rule.of_class) return true;
    return false;
  }

  std::vector<Rule> rules_;
  std::size_t compared_ = 0, added_ = 0;
};

}  // namespace

void apply_svg_style_sheets(const pugi::xml_node& root) {
  std::vector<Rule> rules;
  pugi::xml_node within = root;
  std::size_t kept = 0;
  within.find_node([&](const pugi::xml_node& node) {
    std::string joined;
    if (local_name(node.name()) == "style") add_rules(without_comments(text_of(node, joined)), rules, kept);
    return false;
  });
  if (rules.empty()) return;
  StyledElements walker(std::move(rules));
  walker.for_each(within);
  within.traverse(walker);
}

}  // namespace burin
