#pragma once
#include <burin/ink/decode/remarkable_order.h>
#include <burin/ink/parse/byte_reader.h>

#include <map>

namespace burin {

/// Where the lines of a page's typed text are: y of the baseline of each character's line, by the character,
/// in pixels; also of the two ids that stand for the first and the last line. The file tells the top of the
/// text and its characters only. How high the tablet draws lines is estimated, by the style of each
/// paragraph, and that it breaks long ones is not known.
std::map<RemarkableId, double> remarkable_text_lines(ByteReader block);

}  // namespace burin
