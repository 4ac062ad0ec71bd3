// Decodes InkML traces. A value may follow another without a blank where its sign or prefix parts them. The
// prefixes "!" (absolute), "'" (difference) and '"' (difference of differences) hold for the channel until
// the next one; "*" goes on as before, "?" is unknown, "#" begins a hexadecimal number.
#include <burin/base/error.h>
#include <burin/base/text/quoted_word.h>
#include <burin/ink/decode/inkml_trace.h>
#include <burin/ink/parse/scan.h>
#include <fmt/format.h>

namespace burin {
namespace {

/// Removes a whole number behind a '#' from the front of a text. Returns false, and leaves the text, if there
/// is none.
bool take_hexadecimal(std::string_view& text, double& number) {
  if (!text.starts_with('#')) return false;
  std::string_view digits = text.substr(1);
  unsigned value = 0;
  if (!take_whole(digits, value, 16)) return false;
  text = digits;
  number = value;
  return true;
}

}  // namespace

InkmlTrace::InkmlTrace(std::string_view text, std::size_t channels, std::size_t regular)
    : text_(text), channels_(channels), regular_(regular) {}

bool InkmlTrace::next(std::vector<std::optional<double>>& point) {
  point.assign(channels_.size(), std::nullopt);
  skip_blanks(text_);
  if (text_.empty()) return false;
  std::size_t count = 0;
  for (; !text_.empty() && text_.front() != ','; skip_blanks(text_)) {
    if (count == channels_.size())
      throw Error(fmt::format("a point of more than the {} channels of its format", channels_.size()));
    point[count] = take_value(channels_[count]);
    ++count;
  }
  if (count < regular_) throw Error(fmt::format("a point of {} values, its format has {}", count, regular_));
  if (!text_.empty()) text_.remove_prefix(1);
  return true;
}

/// Takes a value with its prefix from the front of the text.
std::optional<double> InkmlTrace::take_value(Channel& channel) {
  switch (text_.front()) {
    case '!':
      channel.kind = Kind::absolute;
      text_.remove_prefix(1);
      break;
    case '\'':
      channel.kind = Kind::first_difference;
      text_.remove_prefix(1);
      break;
    case '"':
      channel.kind = Kind::second_difference;
      text_.remove_prefix(1);
      break;
    default:
      break;
  }
  skip_blanks(text_);
  const char first = text_.empty() ? '\0' : text_.front();
  double number = 0;
  if (take_number(text_, number) || take_hexadecimal(text_, number)) return advance(channel, number);
  if (first != '*' && first != '?' && first != 'T' && first != 'F')
    throw Error(fmt::format("expected a number, found {}", quoted_word(text_.substr(0, 20))));
  text_.remove_prefix(1);
  if (first == '*') return advance(channel, std::nullopt);
  if (first == '?') return std::nullopt;
  return channel.value = first == 'T' ? 1 : 0;
}

/// Without a number the channel goes on as before.
double InkmlTrace::advance(Channel& channel, std::optional<double> number) {
  switch (channel.kind) {
    case Kind::absolute:
      channel.difference = 0;
      return channel.value = number.value_or(channel.value);
    case Kind::first_difference:
      channel.difference = number.value_or(channel.difference);
      break;
    case Kind::second_difference:
      channel.second = number.value_or(channel.second);
      channel.difference += channel.second;
      break;
  }
  return channel.value += channel.difference;
}

}  // namespace burin
