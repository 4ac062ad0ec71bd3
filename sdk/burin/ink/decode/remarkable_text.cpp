// Reads the typed text of a reMarkable page of version 6: pieces of text, ordered by the ids of neighbouring
// characters, the styles of paragraphs, and a place. An id names a piece's first character; the others have
// the ids that follow.
#include <burin/ink/decode/remarkable_text.h>
#include <burin/ink/parse/remarkable_tagged.h>

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <vector>

namespace burin {
namespace {

constexpr RemarkableId first_line{0, 0xFFFFFFFFFFFE}, last_line{0, 0xFFFFFFFFFFFF};

/// Heights of lines, and where the first begins above the place of the text, as measured by the authors of
/// rmc, https://github.com/ricklupton/rmc; pixels.
constexpr double top = -88, plain_height = 70, heading_height = 150, bullet_height = 35;

double height_of(std::uint8_t style) {
  enum Style : std::uint8_t { heading = 2, bullet = 4, bullet_within = 5 };
  if (style == Style::heading) return heading_height;
  return style == Style::bullet || style == Style::bullet_within ? bullet_height : plain_height;
}

struct Text {
  std::vector<RemarkableNeighbours> characters;
  std::vector<bool> ends_line;                  ///< [character]
  std::map<RemarkableId, std::uint8_t> styles;  ///< by the line end before a paragraph; the first has {0, 0}
  double y = 0;
};

RemarkableId behind(RemarkableId id, std::uint64_t count) { return {id.author, id.number + count}; }

/// Adds the characters of a piece, of which the first and the last tell neighbours. Far more than a page has
/// are left out.
void add_piece(const RemarkableNeighbours& piece, const std::vector<bool>& ends_line, Text& text) {
  constexpr std::size_t most_characters = 100'000;
  for (std::size_t i = 0; i < ends_line.size() && text.characters.size() < most_characters; ++i) {
    text.characters.push_back({behind(piece.own, i), i == 0 ? piece.left : behind(piece.own, i - 1),
                               i + 1 == ends_line.size() ? piece.right : behind(piece.own, i + 1)});
    text.ends_line.push_back(ends_line[i]);
  }
}

/// One flag for each character of a text in UTF-8.
std::vector<bool> line_ends_of(ByteReader part) {
  const std::uint64_t size = part.varint();
  part.take_bytes(1);  // whether all are ASCII
  std::vector<bool> ends;
  for (const char c : part.take_bytes(size)) {
    constexpr unsigned char continues = 0x80, continues_mask = 0xC0;
    if ((static_cast<unsigned char>(c) & continues_mask) != continues) ends.push_back(c == '\n');
  }
  return ends;
}

void read_piece(ByteReader bytes, Text& text) {
  enum Index : std::uint8_t { own = 2, left, right, deleted, characters };
  constexpr std::uint64_t most_deleted = 10'000;  // counted only where others could follow them
  RemarkableNeighbours piece;
  std::vector<bool> ends_line;
  while (!bytes.empty()) {
    const RemarkableValue value = take_remarkable_value(bytes);
    if (value.index == Index::own) piece.own = value.id;
    if (value.index == Index::left) piece.left = value.id;
    if (value.index == Index::right) piece.right = value.id;
    if (value.index == Index::deleted) ends_line.assign(std::min(value.number, most_deleted), false);
    if (value.index == Index::characters) ends_line = line_ends_of(value.content);
  }
  add_piece(piece, ends_line, text);
}

/// Calls `read` for what a part in a part tells the number of.
template <class Read>
void for_each_in(ByteReader part, const Read& read) {
  ByteReader list = take_remarkable_value(part).content;
  for (std::uint64_t left = list.varint(); left > 0 && !list.empty(); --left) read(list);
}

void read_pieces(ByteReader part, Text& text) {
  for_each_in(part, [&](ByteReader& list) { read_piece(take_remarkable_value(list).content, text); });
}

void read_styles(ByteReader part, Text& text) {
  for_each_in(part, [&](ByteReader& list) {
    const RemarkableId line_end = take_remarkable_id(list);
    take_remarkable_value(list);  // who set it
    ByteReader style = take_remarkable_value(list).content;
    style.take_bytes(1);
    text.styles[line_end] = style.take<std::uint8_t>();
  });
}

Text read_text(ByteReader block) {
  enum Index : std::uint8_t { pieces = 1, styles = 2, content = 2, place = 3 };
  Text text;
  while (!block.empty()) {
    RemarkableValue value = take_remarkable_value(block);
    if (value.index == Index::place) {
      value.content.take<double>();  // x
      text.y = value.content.take<double>();
    }
    while (value.index == Index::content && !value.content.empty()) {
      const RemarkableValue list = take_remarkable_value(value.content);
      if (list.index == Index::pieces) read_pieces(list.content, text);
      if (list.index == Index::styles) read_styles(list.content, text);
    }
  }
  return text;
}

}  // namespace

std::map<RemarkableId, double> remarkable_text_lines(ByteReader block) {
  const Text text = read_text(block);
  const auto height_behind = [&](const RemarkableId& line_end) {
    const auto style = text.styles.find(line_end);
    return style == text.styles.end() ? plain_height : height_of(style->second);
  };
  std::map<RemarkableId, double> lines;
  double y = text.y + top + height_behind({});
  lines[first_line] = y;
  for (const std::size_t i : order_of(text.characters)) {
    const RemarkableId id = text.characters[i].own;
    lines[id] = y;
    if (text.ends_line[i]) y += height_behind(id);
  }
  lines[last_line] = y;
  return lines;
}

}  // namespace burin
