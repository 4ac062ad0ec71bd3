// Chooses the channels of a stamp by their names.
#include <burin/base/error.h>
#include <burin/base/text/lower_case.h>
#include <burin/base/text/quoted_word.h>
#include <burin/stamp/files/stamp_channels.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string_view>

namespace burin {
namespace {

std::string_view layer_of(std::string_view name) {
  const std::size_t point = name.rfind('.');
  return point == name.npos ? std::string_view() : name.substr(0, point);
}

std::string_view within_layer(std::string_view name) { return name.substr(name.rfind('.') + 1); }

/// A list of names for a message, "'a', 'b', 'c'", truncated to 12 names.
template <class Names>
std::string list_of(const Names& names) {
  constexpr std::size_t most = 12;
  std::string list;
  std::size_t count = 0;
  for (const auto& name : names) {
    if (count++ == most) return fmt::format("{} and {} more", list, names.size() - most);
    list += (list.empty() ? "" : ", ") + quoted_word(name);
  }
  return list;
}

/// A channel's name split into its meaningful end and the prefix before it.
struct Suffix {
  char axis;  ///< one of r g b x y z, a for alpha
  std::string prefix;
};

std::vector<Suffix> suffixes(std::string_view channel) {
  constexpr std::array<std::pair<std::string_view, char>, 11> known = {{{"red", 'r'},
                                                                        {"green", 'g'},
                                                                        {"blue", 'b'},
                                                                        {"alpha", 'a'},
                                                                        {"r", 'r'},
                                                                        {"g", 'g'},
                                                                        {"b", 'b'},
                                                                        {"a", 'a'},
                                                                        {"x", 'x'},
                                                                        {"y", 'y'},
                                                                        {"z", 'z'}}};
  const std::string low = in_lower_case(std::string(channel));
  std::vector<Suffix> found;
  for (const auto& [word, axis] : known)
    if (low.ends_with(word)) found.push_back({axis, low.substr(0, low.size() - word.size())});
  return found;
}

/// The channels of one layer, grouped by prefix and end of their names.
class Layer {
 public:
  Layer(const std::vector<std::string>& names, std::vector<std::size_t> members)
      : names_(names), members_(std::move(members)) {
    for (const std::size_t member : members_)
      for (const Suffix& suffix : suffixes(within_layer(names_[member])))
        by_suffix_[suffix.prefix][suffix.axis].push_back(member);
  }

  std::vector<std::size_t> choose() const {
    if (members_.size() == 1) return members_;
    refuse_chroma();
    if (const auto vectors = choose_vector(); !vectors.empty()) return vectors;
    std::vector<std::size_t> without_alpha = members_;
    std::erase_if(without_alpha, [&](std::size_t member) { return is_named(member, {"a", "alpha"}); });
    if (without_alpha.size() == 1) return without_alpha;
    for (const std::size_t member : members_)
      if (is_named(member, {"y"})) return {member};
    refuse("none of its channels stands out as the heights, and no three as a vector");
  }

 private:
  bool is_named(std::size_t member, std::initializer_list<std::string_view> words) const {
    return std::ranges::count(words, in_lower_case(std::string(within_layer(names_[member])))) > 0;
  }

  void refuse_chroma() const {
    const auto has = [&](std::string_view word) {
      return std::ranges::any_of(members_, [&](std::size_t member) { return is_named(member, {word}); });
    };
    if (has("ry") || has("by")) refuse("they are luminance and chroma, neither heights nor vectors");
  }

  /// The channels of a vector, or an empty list if no three channels are one.
  std::vector<std::size_t> choose_vector() const {
    std::vector<std::vector<std::size_t>> found;
    for (const auto& [prefix, axes] : by_suffix_)
      for (const std::string_view three : {"rgb", "xyz"}) {
        const auto vector = vector_of(axes, three);
        if (vector.empty()) continue;
        found.push_back(vector);
      }
    // The map sorts prefixes, so the empty one comes first.
    const bool plain = found.size() > 1 && is_plain(found[0]) && !is_plain(found[1]);
    if (found.size() > 1 && !plain) refuse("several of its channels are vectors");
    return found.empty() ? std::vector<std::size_t>() : found.front();
  }

  static std::vector<std::size_t> vector_of(const std::map<char, std::vector<std::size_t>>& axes,
                                            std::string_view three) {
    std::vector<std::size_t> vector;
    for (const char axis : three) {
      const auto named = axes.find(axis);
      if (named == axes.end() || named->second.size() != 1) return {};
      vector.push_back(named->second.front());
    }
    if (const auto alpha = axes.find('a'); alpha != axes.end() && alpha->second.size() == 1)
      vector.push_back(alpha->second.front());
    return vector;
  }

  bool is_plain(const std::vector<std::size_t>& vector) const {
    return is_named(vector.front(), {"r", "red", "x"});
  }

  [[noreturn]] void refuse(std::string_view why) const {
    std::vector<std::string> names;
    for (const std::size_t member : members_) names.push_back(names_[member]);
    throw Error(fmt::format("holds the channels {}: {}; a channel, or three, can be chosen by name",
                            list_of(names), why));
  }

  const std::vector<std::string>& names_;
  const std::vector<std::size_t> members_;
  /// [prefix][axis] the channels with such names.
  std::map<std::string, std::map<char, std::vector<std::size_t>>> by_suffix_;
};

std::set<std::string> layers_of(const std::vector<std::string>& names) {
  std::set<std::string> layers;
  for (const std::string& name : names) layers.emplace(layer_of(name));
  return layers;
}

std::string chosen_layer(const std::set<std::string>& layers, const std::string& wanted) {
  if (layers.contains(wanted)) return wanted;
  std::vector<std::string> found;
  for (const std::string& layer : layers)
    if (wanted.empty() || layer.ends_with("." + wanted) || layer.starts_with(wanted + "."))
      found.push_back(layer);
  if (found.size() == 1) return found.front();
  if (found.empty())
    throw Error(fmt::format("has no layer {}; there are: {}", quoted_word(wanted), list_of(layers)));
  throw Error(
      fmt::format("holds several layers, of which one must be chosen by its name: {}", list_of(found)));
}

std::size_t channel_named(const std::vector<std::string>& names, const std::string& layer,
                          std::string_view wanted) {
  const std::string in_layer = layer.empty() ? std::string(wanted) : fmt::format("{}.{}", layer, wanted);
  for (const std::string_view name : {std::string_view(in_layer), wanted})
    if (const auto found = std::ranges::find(names, name); found != names.end())
      return static_cast<std::size_t>(found - names.begin());
  throw Error(fmt::format("has no channel {}; there are: {}", quoted_word(wanted), list_of(names)));
}

std::vector<std::size_t> channels_named(const std::vector<std::string>& names, const std::string& layer,
                                        std::string_view wanted) {
  if (std::ranges::count(names, wanted) > 0 || wanted.find(',') == wanted.npos)
    return {channel_named(names, layer, wanted)};
  std::vector<std::size_t> used;
  for (std::size_t begin = 0; begin <= wanted.size();) {
    const std::size_t end = std::min(wanted.find(',', begin), wanted.size());
    used.push_back(channel_named(names, layer, wanted.substr(begin, end - begin)));
    begin = end + 1;
  }
  if (used.size() != 3 && used.size() != 4)
    throw Error(fmt::format("cannot be read by {} channels; a stamp has 1, 3 or 4", used.size()));
  return used;
}

std::vector<std::size_t> members_of(const std::vector<std::string>& names, std::string_view layer) {
  std::vector<std::size_t> members;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (layer_of(names[i]) == layer) members.push_back(i);
  return members;
}

}  // namespace

ChannelChoice choose_channels(const std::vector<std::string>& names, const std::string& layer,
                              const std::string& channel) {
  const std::set<std::string> layers = layers_of(names);
  ChannelChoice choice;
  if (!channel.empty())
    choice.used = channels_named(names, layer.empty() ? layer : chosen_layer(layers, layer), channel);
  else
    choice.used = Layer(names, members_of(names, chosen_layer(layers, layer))).choose();
  for (std::size_t i = 0; i < names.size(); ++i)
    if (std::ranges::count(choice.used, i) == 0) choice.unused.push_back(i);
  return choice;
}

}  // namespace burin
