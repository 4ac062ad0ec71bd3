// Writes recordings as InkML and CSV. Numbers are the shortest that are read back as the same.
#include <burin/ink/decode/inkml_format.h>
#include <burin/ink/pen_file_writers.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
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

void write_inkml_context(std::size_t number, const Given& given, std::ostream& out) {
  out << "    <context xml:id=\"context" << number << "\">\n      <traceFormat>\n";
  for (std::size_t i = 0; i < channels.size(); ++i)
    if (given[i]) out << "        <channel " << channels[i].inkml << "/>\n";
  out << "      </traceFormat>\n    </context>\n";
}

void write_trace(const RecordedStroke& stroke, std::size_t context, const Given& given, std::ostream& out) {
  out << "  <trace contextRef=\"#context" << context << "\">";
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

}  // namespace

void write_inkml(std::span<const Recording> recordings, std::ostream& out) {
  std::vector<Given> contexts;
  for_each_stroke(recordings, [&](const RecordedStroke&, const Given& given) {
    if (std::ranges::find(contexts, given) == contexts.end()) contexts.push_back(given);
  });
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<ink xmlns=\"http://www.w3.org/2003/InkML\">\n";
  if (std::ranges::any_of(contexts, [](const Given& given) { return given[z_channel]; }))
    out << fmt::format("  <annotation type=\"{}\">{}</annotation>\n", inkml_space_annotation,
                       inkml_object_space);
  out << "  <definitions>\n";
  for (std::size_t i = 0; i < contexts.size(); ++i) write_inkml_context(i, contexts[i], out);
  out << "  </definitions>\n";
  for_each_stroke(recordings, [&](const RecordedStroke& stroke, const Given& given) {
    const auto context = std::ranges::find(contexts, given) - contexts.begin();
    write_trace(stroke, static_cast<std::size_t>(context), given, out);
  });
  out << "</ink>\n";
}

void write_pen_csv(std::span<const Recording> recordings, std::ostream& out) {
  Given any{};
  bool erasers = false;
  for_each_stroke(recordings, [&](const RecordedStroke& stroke, const Given& given) {
    std::ranges::transform(any, given, any.begin(), std::logical_or());
    erasers |= stroke.drawn_by.eraser;
  });
  out << "stroke";
  for (std::size_t i = 0; i < channels.size(); ++i)
    if (any[i]) out << ',' << channels[i].csv;
  out << (erasers ? ",eraser\n" : "\n");
  std::size_t number = 0;
  std::string line;
  for_each_stroke(recordings, [&](const RecordedStroke& stroke, const Given& given) {
    ++number;
    for (const Sample& sample : stroke.samples) {
      line = std::to_string(number);
      for (std::size_t i = 0; i < channels.size(); ++i) {
        if (!any[i]) continue;
        line += ',';
        if (given[i]) channels[i].append(line, sample);
      }
      if (erasers) line += stroke.drawn_by.eraser ? ",1" : ",0";
      out << line << '\n';
    }
  });
}

}  // namespace burin
