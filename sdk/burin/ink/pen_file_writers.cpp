// Writes recordings as InkML and CSV. Numbers are the shortest that are read back as the same.
#include <burin/ink/decode/inkml_format.h>
#include <burin/ink/parse/csv_columns.h>
#include <burin/ink/pen_file_writers.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <span>
#include <string>
#include <vector>

namespace burin {
namespace {

/// What a sample has, for both formats.
struct WrittenChannel {
  const char* csv;
  const char* inkml;  ///< the attributes of the channel
  bool (*given)(const Recording& recording, const RecordedStroke& stroke);
  void (*append)(std::string& line, const Sample& sample);
  void (*append_inkml)(std::string& line, const Sample& sample) = append;  ///< to a trace
};

template <class Number>
void append(std::string& line, Number value) {
  fmt::format_to(std::back_inserter(line), "{}", value);
}

constexpr std::array channels = {
    WrittenChannel{"x", R"(name="X" type="decimal")",
                   [](const Recording&, const RecordedStroke&) { return true; },
                   [](std::string& line, const Sample& s) { append(line, s.position.x()); }},
    WrittenChannel{"y", R"(name="Y" type="decimal")",
                   [](const Recording&, const RecordedStroke&) { return true; },
                   [](std::string& line, const Sample& s) { append(line, s.position.y()); }},
    WrittenChannel{"z", R"(name="Z" type="decimal")",
                   [](const Recording& r, const RecordedStroke&) { return r.space == StrokeSpace::object; },
                   [](std::string& line, const Sample& s) { append(line, s.position.z()); }},
    WrittenChannel{"time", R"(name="T" type="decimal" units="s")",
                   [](const Recording&, const RecordedStroke& s) { return s.fields.time; },
                   [](std::string& line, const Sample& s) { append(line, s.time); }},
    WrittenChannel{"pressure", R"(name="F" type="decimal" min="0" max="1" units="dev")",
                   [](const Recording&, const RecordedStroke& s) { return s.fields.pressure; },
                   [](std::string& line, const Sample& s) { append(line, s.pen.pressure); }},
    WrittenChannel{"tilt_x", R"(name="OTx" type="decimal" units="rad")",
                   [](const Recording&, const RecordedStroke& s) { return s.fields.tilt; },
                   [](std::string& line, const Sample& s) { append(line, s.pen.tilt_x); }},
    WrittenChannel{"tilt_y", R"(name="OTy" type="decimal" units="rad")",
                   [](const Recording&, const RecordedStroke& s) { return s.fields.tilt; },
                   [](std::string& line, const Sample& s) { append(line, s.pen.tilt_y); }},
    WrittenChannel{"twist", R"(name="OR" type="decimal" units="rad")",
                   [](const Recording&, const RecordedStroke& s) { return s.fields.twist; },
                   [](std::string& line, const Sample& s) { append(line, s.pen.twist); }},
    WrittenChannel{"barrel", R"(name="B1" type="boolean")",
                   [](const Recording&, const RecordedStroke& s) { return s.fields.barrel; },
                   [](std::string& line, const Sample& s) { line += s.barrel ? "1" : "0"; },
                   [](std::string& line, const Sample& s) { line += s.barrel ? "T" : "F"; }}};

constexpr std::size_t z_channel = 2;

/// Whether a character of a name needs no quotes anywhere.
bool is_plain(char letter) {
  return ('a' <= letter && letter <= 'z') || ('A' <= letter && letter <= 'Z') ||
         ('0' <= letter && letter <= '9') || letter == '-' || letter == '_';
}

std::string csv_cell(const std::string& text) {
  if (std::ranges::all_of(text, is_plain) && !is_absent_cell(text)) return text;
  std::string cell = "\"";
  for (const char letter : text) cell += letter == '"' ? "\"\"" : std::string(1, letter);
  return cell + '"';
}

/// A text within quotes of XML. Characters that XML cannot have are left out.
std::string xml_value(const std::string& text) {
  std::string value;
  for (const char letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    if (is_plain(letter) || code >= 0x80 || letter == ' ')
      value += letter;
    else if (code > ' ' || letter == '\t' || letter == '\n' || letter == '\r')
      value += fmt::format("&#{};", code);
  }
  return value;
}

/// What CSV has of a whole stroke.
struct StrokeColumn {
  const char* name;
  bool (*given)(const DrawnBy& drawn_by);
  std::string (*cell)(const DrawnBy& drawn_by);
};

constexpr std::array stroke_columns = {
    StrokeColumn{"eraser", [](const DrawnBy& by) { return by.eraser; },
                 [](const DrawnBy& by) -> std::string { return by.eraser ? "1" : "0"; }},
    StrokeColumn{"tool", [](const DrawnBy& by) { return !by.tool.empty(); },
                 [](const DrawnBy& by) { return csv_cell(by.tool); }}};

using Given = std::array<bool, channels.size()>;

Given given_in(const Recording& recording, const RecordedStroke& stroke) {
  Given given{};
  std::ranges::transform(channels, given.begin(),
                         [&](const WrittenChannel& channel) { return channel.given(recording, stroke); });
  return given;
}

/// Calls `take` with each stroke that has samples.
template <class Take>
void for_each_stroke(std::span<const Recording> recordings, const Take& take) {
  for (const Recording& recording : recordings)
    for (const RecordedStroke& stroke : recording.strokes)
      if (!stroke.samples.empty()) take(stroke, given_in(recording, stroke));
}

/// The number of an item, which is added if it is new.
template <class Item>
std::size_t number_in(std::vector<Item>& items, const Item& item) {
  const auto found = std::ranges::find(items, item);
  const auto number = static_cast<std::size_t>(found - items.begin());
  if (found == items.end()) items.push_back(item);
  return number;
}

void write_inkml_brush(std::size_t number, const DrawnBy& drawn_by, std::ostream& out) {
  const auto write_property = [&out](std::string_view name, std::string_view value) {
    out << "      <brushProperty name=\"" << name << "\" value=\"" << value << "\"/>\n";
  };
  out << "    <brush xml:id=\"brush" << number << "\">\n";
  if (!drawn_by.tool.empty()) write_property(inkml_tool_property, xml_value(drawn_by.tool));
  if (drawn_by.eraser) write_property(inkml_eraser_property, "true");
  out << "    </brush>\n";
}

void write_inkml_context(std::size_t number, const Given& given, std::ostream& out) {
  out << "    <context xml:id=\"context" << number << "\">\n      <traceFormat>\n";
  for (std::size_t i = 0; i < channels.size(); ++i)
    if (given[i]) out << "        <channel " << channels[i].inkml << "/>\n";
  out << "      </traceFormat>\n    </context>\n";
}

/// `references`: the attributes that name context and brush.
void write_trace(const RecordedStroke& stroke, std::string_view references, const Given& given,
                 std::ostream& out) {
  out << "  <trace" << references << ">";
  std::string line;
  for (const Sample& sample : stroke.samples) {
    line = &sample == &stroke.samples.front() ? "\n" : ",\n";
    for (std::size_t i = 0; i < channels.size(); ++i) {
      if (!given[i]) continue;
      if (line.back() != '\n') line += ' ';
      channels[i].append_inkml(line, sample);
    }
    out << line;
  }
  out << "\n  </trace>\n";
}

/// `any`: the channels that have a column; `end`: the cells of the stroke as a whole.
void write_rows(const RecordedStroke& stroke, const std::string& number, const Given& given, const Given& any,
                const std::string& end, std::ostream& out) {
  std::string line;
  for (const Sample& sample : stroke.samples) {
    line = number;
    for (std::size_t i = 0; i < channels.size(); ++i) {
      if (!any[i]) continue;
      line += ',';
      if (given[i]) channels[i].append(line, sample);
    }
    out << line << end << '\n';
  }
}

}  // namespace

void write_inkml(std::span<const Recording> recordings, std::ostream& out) {
  std::vector<Given> contexts;
  std::vector<DrawnBy> brushes = {DrawnBy{}};  // the first one, of which nothing is known, is not written
  for_each_stroke(recordings, [&](const RecordedStroke& stroke, const Given& given) {
    number_in(contexts, given);
    number_in(brushes, stroke.drawn_by);
  });
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<ink xmlns=\"http://www.w3.org/2003/InkML\">\n";
  if (std::ranges::any_of(contexts, [](const Given& given) { return given[z_channel]; }))
    out << fmt::format("  <annotation type=\"{}\">{}</annotation>\n", inkml_space_annotation,
                       inkml_object_space);
  out << "  <definitions>\n";
  for (std::size_t i = 0; i < contexts.size(); ++i) write_inkml_context(i, contexts[i], out);
  for (std::size_t i = 1; i < brushes.size(); ++i) write_inkml_brush(i, brushes[i], out);
  out << "  </definitions>\n";
  for_each_stroke(recordings, [&](const RecordedStroke& stroke, const Given& given) {
    std::string references = fmt::format(" contextRef=\"#context{}\"", number_in(contexts, given));
    if (const std::size_t brush = number_in(brushes, stroke.drawn_by); brush > 0)
      references += fmt::format(" brushRef=\"#brush{}\"", brush);
    write_trace(stroke, references, given, out);
  });
  out << "</ink>\n";
}

void write_pen_csv(std::span<const Recording> recordings, std::ostream& out) {
  Given any{};
  std::array<bool, stroke_columns.size()> any_of_strokes{};
  for_each_stroke(recordings, [&](const RecordedStroke& stroke, const Given& given) {
    std::ranges::transform(any, given, any.begin(), std::logical_or());
    for (std::size_t i = 0; i < stroke_columns.size(); ++i)
      any_of_strokes[i] |= stroke_columns[i].given(stroke.drawn_by);
  });
  out << "stroke";
  for (std::size_t i = 0; i < channels.size(); ++i)
    if (any[i]) out << ',' << channels[i].csv;
  for (std::size_t i = 0; i < stroke_columns.size(); ++i)
    if (any_of_strokes[i]) out << ',' << stroke_columns[i].name;
  out << '\n';
  std::size_t number = 0;
  for_each_stroke(recordings, [&](const RecordedStroke& stroke, const Given& given) {
    std::string end;
    for (std::size_t i = 0; i < stroke_columns.size(); ++i)
      if (any_of_strokes[i]) end += ',' + stroke_columns[i].cell(stroke.drawn_by);
    write_rows(stroke, std::to_string(++number), given, any, end, out);
  });
}

}  // namespace burin
