// Reads what `libinput record` writes: YAML with the axes of each device under devices/evdev/absinfo, and its
// events as lists [sec, usec, type, code, value] under devices/events. It is parsed as a stream, since
// recordings have hundreds of thousands of numbers, and without the lines of events, which are most of it.
#include <burin/base/error.h>
#include <burin/ink/decode/evdev_frames.h>
#include <burin/ink/decode/libinput_lines.h>
#include <burin/ink/kinds/kinds.h>
#include <burin/ink/parse/scan.h>
#include <burin/ink/pen_file.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <cstdint>
#include <istream>
#include <optional>
#include <streambuf>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace burin {
namespace {

/// A fault at a line of the YAML, from 0.
struct YamlFault : Error {
  YamlFault(const std::string& what, const YAML::Mark& mark) : Error(what), line(mark.line) {}
  int line;
};

/// Follows the stream of a recording.
class Recorded : public YAML::EventHandler {
 public:
  /// The file must outlive the object.
  explicit Recorded(const PenFileText& file) : text_(file) {}

  PenFile finish();

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t) override { take_scalar(mark, {}); }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override { take_scalar(mark, {}); }
  void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t,
                const std::string& value) override {
    take_scalar(mark, value);
  }
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {
    open(false);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {
    open(true);
  }
  void OnMapEnd() override { close(); }

 private:
  /// An open map or list; of a map, the key of the value that comes next, if it was read.
  struct Level {
    bool map = false, has_key = false;
    std::string key = {};
  };
  void open(bool map);
  void close();
  void take_scalar(const YAML::Mark& mark, const std::string& value);
  void take_number(const YAML::Mark& mark, const std::string& value);
  void value_ended();
  bool in_event() const;
  bool in_events() const;
  void take_event(const EvdevEvent& event);
  bool in_axis() const;
  bool at_path(std::initializer_list<std::string_view> path) const;

  TextWindow text_;  ///< for the runs of events
  std::vector<Level> levels_;
  std::vector<std::int64_t> numbers_;  ///< of the event or axis that is open
  YAML::Mark mark_;
  EvdevAxes axes_;
  std::optional<EvdevFrames> frames_;  ///< of the device
  std::string name_;                   ///< of the device
  PenFile content_;
};

/// Whether the open levels have these keys; "" stands for a list, "*" for a map at any key.
bool Recorded::at_path(std::initializer_list<std::string_view> path) const {
  if (levels_.size() < path.size()) return false;
  std::size_t i = 0;
  for (const std::string_view key : path) {
    const Level& level = levels_[i++];
    const bool fits = key.empty() ? !level.map : level.map && (key == "*" || level.key == key);
    if (!fits) return false;
  }
  return true;
}

// devices: [{evdev: {absinfo: {0: [...]}}, events: [{evdev: [[...], ...]}]}]
bool Recorded::in_axis() const {
  return levels_.size() == 6 && at_path({"devices", "", "evdev", "absinfo", "*", ""});
}
bool Recorded::in_event() const {
  return levels_.size() == 7 && at_path({"devices", "", "events", "", "evdev", "", ""});
}

bool Recorded::in_events() const {
  return levels_.size() == 6 && at_path({"devices", "", "events", "", "evdev", ""});
}

void Recorded::take_event(const EvdevEvent& event) {
  if (!frames_) frames_.emplace(axes_);
  frames_->take(event);
}

void Recorded::open(bool map) {
  // A new device.
  if (map && levels_.size() == 2 && at_path({"devices", ""})) {
    axes_.clear();
    frames_.reset();
    name_.clear();
  }
  levels_.push_back({.map = map});
  if (in_axis() || in_event()) numbers_.clear();
}

void Recorded::close() {
  if (in_axis() && numbers_.size() == 5) {
    unsigned code = 0;
    if (read_whole(levels_[4].key, code))
      axes_[code] = {static_cast<double>(numbers_[0]), static_cast<double>(numbers_[1]),
                     static_cast<double>(numbers_[4])};
  } else if (in_event()) {
    if (numbers_.size() != 5) throw YamlFault("an event needs five numbers: sec usec type code value", mark_);
    take_event({static_cast<double>(numbers_[0]) + static_cast<double>(numbers_[1]) / 1e6,
                static_cast<unsigned>(numbers_[2]), static_cast<unsigned>(numbers_[3]),
                static_cast<int>(numbers_[4])});
  }
  levels_.pop_back();
  // The end of a device.
  if (frames_ && levels_.size() == 2 && at_path({"devices", ""})) {
    PenFile of_device = frames_->finish();
    frames_.reset();
    content_.hovering += of_device.hovering;
    if (content_.strokes.empty() && !of_device.strokes.empty()) content_.device = name_;
    if (!of_device.strokes.empty()) content_.unit = of_device.unit;
    for (PenStroke& stroke : of_device.strokes) content_.strokes.push_back(std::move(stroke));
  }
  value_ended();
}

void Recorded::value_ended() {
  if (!levels_.empty()) levels_.back().has_key = false;
}

void Recorded::take_scalar(const YAML::Mark& mark, const std::string& value) {
  mark_ = mark;
  if (levels_.empty()) throw YamlFault("expected a map", mark);
  Level& level = levels_.back();
  if (level.map && !level.has_key) {
    level.key = value;
    level.has_key = true;
    return;
  }
  if (in_axis() || in_event()) take_number(mark, value);
  if (in_events())
    for_each_event_of_run(text_, value, [this](const EvdevEvent& event) { take_event(event); });
  if (at_path({"devices", "", "evdev", "name"}) && levels_.size() == 4) {
    name_ = value;
    if (content_.strokes.empty()) content_.device = value;
  }
  value_ended();
}

void Recorded::take_number(const YAML::Mark& mark, const std::string& value) {
  std::int64_t number = 0;
  constexpr std::int64_t most = std::int64_t{1} << 40;
  if (!read_whole(value, number) || number > most || number < -most)
    throw YamlFault("expected a whole number", mark);
  if (numbers_.size() < 16) numbers_.push_back(number);
}

PenFile Recorded::finish() { return std::move(content_); }

/// Gives a parser the lines of a recording. Ends where brackets are open within brackets, of which the parser
/// would keep a hundred times their size; those in comments and texts count too, but are closed or few.
class LineBuffer : public std::streambuf {
 public:
  explicit LineBuffer(const PenFileText& file) : lines_(file) {}

  bool ended_by_brackets() const { return open_ > most_open; }

 private:
  static constexpr int most_open = 200;

  int_type underflow() override {
    if (ended_by_brackets() || !lines_.next(line_)) return traits_type::eof();
    line_ += '\n';
    for (const char c : line_) {
      if (c == '[' || c == '{') ++open_;
      if ((c == ']' || c == '}') && open_ > 0) --open_;
      if (ended_by_brackets()) return traits_type::eof();
    }
    setg(line_.data(), line_.data(), line_.data() + line_.size());
    return traits_type::to_int_type(line_.front());
  }

  LibinputLines lines_;
  std::string line_;
  int open_ = 0;
};

/// The line of the recording, from 1, that a line which the parser saw stands for, from 0.
std::string line_of(const PenFileText& file, int line) {
  LibinputLines lines(file);
  std::string text;
  for (int passed = 0; lines.next(text);)
    if (passed++ == line) return std::to_string(lines.number());
  // A fault at the end of the text is on the line after the last.
  return std::to_string(lines.number() + 1);
}

void parse(const PenFileText& file, Recorded& recorded) {
  LineBuffer lines(file);
  try {
    std::istream stream(&lines);
    YAML::Parser parser(stream);
    parser.HandleNextDocument(recorded);
  } catch (const Error&) {
    if (!lines.ended_by_brackets()) throw;
  } catch (const YAML::Exception&) {
    if (!lines.ended_by_brackets()) throw;
  }
  if (lines.ended_by_brackets()) throw FileError(file.path.string(), "more than 200 open brackets of YAML");
}

}  // namespace

bool is_libinput(std::string_view text) {
  const std::string_view head = text.substr(0, 4096);
  return head.starts_with("# libinput record") || head.starts_with("libinput:") ||
         head.find("\nlibinput:") != head.npos;
}

PenFile read_libinput(const PenFileText& file) {
  Recorded recorded(file);
  try {
    parse(file, recorded);
  } catch (const YamlFault& fault) {
    throw FileError(file.path.string(), line_of(file, fault.line), fault.what());
  } catch (const YAML::Exception& exception) {
    throw FileError(file.path.string(), line_of(file, exception.mark.line),
                    "malformed YAML: " + exception.msg);
  }
  return recorded.finish();
}

}  // namespace burin
