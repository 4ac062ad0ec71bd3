// Reads a `.stroke` file line by line, and checks the order of the lines.
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/base/text/json_value.h>
#include <burin/stroke/files/stroke_lines.h>
#include <burin/stroke/stroke_file.h>
#include <fmt/format.h>

#include <algorithm>

namespace burin {
namespace {

/// Parses the lines of a file in order.
class Reader {
 public:
  explicit Reader(std::string path) : path_(std::move(path)) {}

  /// `complete`: whether the line ends with a newline.
  void take_line(std::string_view text, bool complete);

  Recording finish();

 private:
  std::optional<JsonValue> parse(std::string_view text, bool complete);
  void take(const JsonValue& line);
  void take_object(const JsonValue& line);
  void take_begin(const JsonValue& line);
  void take_end(const JsonValue& line);
  void take_sample(const JsonValue& line);
  bool goes_on_with(const Sample& sample) const;

  std::string path_;
  std::size_t line_ = 0;
  bool header_seen_ = false;
  bool open_ = false;  ///< within a stroke
  std::vector<Column> columns_;
  Recording recording_;
};

void Reader::take_line(std::string_view text, bool complete) {
  ++line_;
  if (text.find_first_not_of(" \t\r") == text.npos) return;
  if (const auto sample = open_ ? plain_sample(text, columns_) : std::nullopt;
      sample && goes_on_with(*sample)) {
    recording_.strokes.back().samples.push_back(*sample);
    return;
  }
  if (const auto line = parse(text, complete))
    take(*line);
  else
    recording_.cut_off_at = line_;
}

/// Parses a line; returns nothing for a line that was cut off.
std::optional<JsonValue> Reader::parse(std::string_view text, bool complete) {
  try {
    return JsonValue::parse_line(text, path_, line_);
  } catch (const MalformedJson&) {
    if (complete && !header_seen_ && text.find("burin_stroke") == text.npos)
      throw FileError(
          path_, std::to_string(line_),
          "no .stroke file, whose header {\"burin_stroke\": 1, ...} comes first; `burin import` reads "
          "recordings of other programs");
    if (complete) throw;
    return std::nullopt;
  }
}

void Reader::take(const JsonValue& line) {
  if (!header_seen_) {
    if (!line.is_object() || !line.find("burin_stroke"))
      line.reject("the header {\"burin_stroke\": 1, ...} must come first");
    HeaderLine header = parse_header(line);
    recording_.space = header.space;
    recording_.camera = header.camera;
    recording_.device = header.device;
    header_seen_ = true;
  } else if (line.is_array()) {
    take_sample(line);
  } else if (line.is_object()) {
    take_object(line);
  } else {
    line.reject("the line is neither an object nor a sample");
  }
}

void Reader::take_object(const JsonValue& line) {
  if (line.find("burin_stroke")) line.reject("a second header");
  if (line.find("begin")) take_begin(line);
  if (line.find("end")) take_end(line);
}

void Reader::take_begin(const JsonValue& line) {
  if (open_) line.reject("a stroke begins before the one before has its end");
  BeginLine begin = parse_begin(line, recording_.space);
  recording_.strokes.push_back(std::move(begin.stroke));
  columns_ = std::move(begin.columns);
  open_ = true;
}

void Reader::take_end(const JsonValue& line) {
  const JsonValue end = line.member("end");
  if (!end.is_boolean() || !end.boolean()) end.reject_type("true");
  if (!open_) line.reject("an end outside a stroke");
  open_ = false;
}

/// Whether the open stroke may go on with a sample.
bool Reader::goes_on_with(const Sample& sample) const {
  const std::vector<Sample>& samples = recording_.strokes.back().samples;
  return samples.empty() || sample.time >= samples.back().time;
}

void Reader::take_sample(const JsonValue& line) {
  if (!open_) line.reject("a sample outside a stroke");
  const Sample sample = parse_sample(line, columns_);
  std::vector<Sample>& samples = recording_.strokes.back().samples;
  if (!goes_on_with(sample))
    line.reject(fmt::format("time falls from {} to {}", samples.back().time, sample.time));
  samples.push_back(sample);
}

Recording Reader::finish() {
  if (!header_seen_) throw FileError(path_, "1", "the header {\"burin_stroke\": 1, ...} is missing");
  if (open_ && !recording_.cut_off_at) recording_.cut_off_at = line_;
  return std::move(recording_);
}

}  // namespace

Recording read_strokes(const std::filesystem::path& path) { return read_strokes(path, read_file(path)); }

Recording read_strokes(const std::filesystem::path& path, std::string_view text) {
  Reader reader(path.string());
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    reader.take_line(text.substr(begin, end - begin), end < text.size());
    begin = end + 1;
  }
  return reader.finish();
}

}  // namespace burin
