// Reads InkML: traces in nested groups, whose contexts tell the channels of their points.
#include <burin/base/error.h>
#include <burin/ink/decode/inkml_channels.h>
#include <burin/ink/decode/inkml_clocks.h>
#include <burin/ink/decode/inkml_format.h>
#include <burin/ink/decode/inkml_trace.h>
#include <burin/ink/kinds/kinds.h>
#include <burin/ink/parse/scan.h>
#include <burin/ink/pen_file.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace burin {
namespace {

/// Whether a program of the office wrote the file.
bool from_office(std::string_view text) {
  return text.find("schemas.microsoft.com/ink") != text.npos || text.find("fitToCurve") != text.npos ||
         text.find("id=\"inkSrc") != text.npos;
}

/// Whether an annotation, as write_inkml() makes it, says that strokes lie in space: by itself Z is the
/// height of the pen above the paper.
bool tells_of_space(const pugi::xml_node& ink) {
  return std::ranges::any_of(ink.children(), [](const pugi::xml_node& node) {
    return local_name(node.name()) == "annotation" &&
           std::string_view(attribute(node, "type").value()) == inkml_space_annotation &&
           std::string_view(node.text().get()) == inkml_object_space;
  });
}

/// What holds for the traces of a group, by references "#id".
struct Around {
  std::string context, brush;

  void take(const pugi::xml_node& node) {
    if (const pugi::xml_attribute own = attribute(node, "contextRef")) context = own.value();
    if (const pugi::xml_attribute own = attribute(node, "brushRef")) brush = own.value();
  }
};

/// Reads the traces of a file.
class InkmlReader {
 public:
  explicit InkmlReader(const PenFileText& file)
      : xml_(file),
        formats_(xml_),
        brushes_(xml_),
        clocks_(xml_),
        office_(from_office(file.text)),
        in_space_(tells_of_space(xml_.root())) {}

  PenFile read() {
    collect_defined(xml_.root());
    read_group(xml_.root(), {});
    if ((office_ || elevated_) && !tilted_) drop_tilt();
    if (heights_) content_.not_used.emplace_back("Z");
    return std::move(content_);
  }

 private:
  void collect_defined(const pugi::xml_node& root);
  void read_group(const pugi::xml_node& group, Around around);
  void read_element(const pugi::xml_node& node, const Around& around);
  void read_defined(const pugi::xml_node& view, const Around& around);
  void read_trace(const pugi::xml_node& trace, Around around);
  void read_points(const pugi::xml_node& trace, const InkmlChannels& channels, const DrawnBy& drawn_by,
                   double clock);
  void add_points(const pugi::xml_node& trace, PenStroke stroke);
  void drop_tilt();

  XmlFile xml_;
  InkmlFormats formats_;
  InkmlBrushes brushes_;
  InkmlClocks clocks_;
  bool office_, in_space_;
  bool heights_ = false;   ///< some trace has a Z that is no coordinate
  bool tilted_ = false;    ///< some point has a tilt other than 0
  bool elevated_ = false;  ///< some trace has an elevation
  PenFile content_;
  std::map<std::string, pugi::xml_node> defined_;  ///< traces and groups of definitions, by "#id"
  std::map<std::string, std::size_t> stroke_of_;   ///< the stroke that a trace made last, by "#id"
};

/// Definitions hold traces that are drawn only where a view refers to them.
void InkmlReader::collect_defined(const pugi::xml_node& root) {
  for (const pugi::xml_node& node : root.children()) {
    if (local_name(node.name()) != "definitions") continue;
    for (const pugi::xml_node& one : node.children()) {
      const std::string_view name = local_name(one.name());
      if (name == "trace" || name == "traceGroup")
        defined_.emplace(std::string("#") + attribute(one, "id").value(), one);
    }
  }
}

/// Takes the traces of a group and of the groups in it. A context that stands between them holds for those
/// that follow.
void InkmlReader::read_group(const pugi::xml_node& group, Around around) {
  around.take(group);
  for (const pugi::xml_node& node : group.children()) {
    if (local_name(node.name()) == "context") around.context = InkmlFormats::reference_of(node);
    read_element(node, around);
  }
}

void InkmlReader::read_element(const pugi::xml_node& node, const Around& around) {
  const std::string_view name = local_name(node.name());
  if (name == "traceGroup") read_group(node, around);
  if (name == "trace") read_trace(node, around);
  if (name == "traceView") read_defined(node, around);
}

/// Takes what a view and the views in it refer to. What is no definition is taken where it stands.
void InkmlReader::read_defined(const pugi::xml_node& view, const Around& around) {
  if (const auto node = defined_.extract(attribute(view, "traceDataRef").value()))
    read_element(node.mapped(), around);
  for (const pugi::xml_node& one : view.children())
    if (local_name(one.name()) == "traceView") read_defined(one, around);
}

void InkmlReader::read_trace(const pugi::xml_node& trace, Around around) {
  around.take(trace);
  const InkmlChannels channels(formats_.of(trace, around.context), office_, in_space_);
  if (!channels.has_position()) xml_.reject(trace, "a format without X or Y");
  elevated_ |= channels.has_elevation();
  heights_ |= channels.has_height();
  try {
    read_points(trace, channels, brushes_.of(around.brush.empty() ? around.context : around.brush),
                clocks_.of(around.context));
  } catch (const FileError&) {
    throw;
  } catch (const Error& error) {
    xml_.reject(trace, error.what());
  }
  if (channels.in_millimetres() && !content_.strokes.empty()) content_.unit = "mm";
}

/// `clock`: when the times of the trace's context begin, seconds.
void InkmlReader::read_points(const pugi::xml_node& trace, const InkmlChannels& channels,
                              const DrawnBy& drawn_by, double clock) {
  const bool lifted = std::string_view(attribute(trace, "type").value()) == "penUp";
  double offset = 0;  // milliseconds
  std::string_view said = attribute(trace, "timeOffset").value();
  take_number(said, offset);
  std::string joined;
  InkmlTrace points(text_of(trace, joined), channels.format().channels.size(), channels.format().regular);
  PenStroke empty = channels.empty_stroke();
  empty.drawn_by = drawn_by;
  PenStroke stroke = empty;
  InkmlValues values, held(channels.format().channels.size());
  const auto finish_stroke = [&] {
    channels.drop_unknown(stroke, held);
    add_points(trace, std::exchange(stroke, empty));
  };
  while (points.next(values)) {
    channels.hold(values, held);
    if (lifted || !channels.touches(values)) {
      ++content_.hovering;
      finish_stroke();
      continue;
    }
    stroke.samples.push_back(channels.sample(values, clock + offset / 1000));
    tilted_ |= channels.tilted(values);
  }
  finish_stroke();
}

/// Adds a stroke, or goes on with that of the trace before of which this one is a continuation.
void InkmlReader::add_points(const pugi::xml_node& trace, PenStroke stroke) {
  if (stroke.samples.empty()) return;
  const std::string_view part = attribute(trace, "continuation").value();
  const auto before = stroke_of_.find(attribute(trace, "priorRef").value());
  const bool goes_on = (part == "middle" || part == "end") && before != stroke_of_.end() &&
                       content_.strokes[before->second].drawn_by == stroke.drawn_by &&
                       join_fields(content_.strokes[before->second].fields, stroke.fields);
  const std::size_t at = goes_on ? before->second : content_.strokes.size();
  if (goes_on)
    std::ranges::move(stroke.samples, std::back_inserter(content_.strokes[at].samples));
  else
    content_.strokes.push_back(std::move(stroke));
  if (const pugi::xml_attribute id = attribute(trace, "id")) stroke_of_[std::string("#") + id.value()] = at;
}

/// Office programs declare the tilt of pens that have none, and write 0 for it. An elevation of 0 throughout,
/// of a pen that lies flat, is none in any file.
void InkmlReader::drop_tilt() {
  for (PenStroke& stroke : content_.strokes) {
    stroke.fields.tilt = false;
    for (Sample& sample : stroke.samples) sample.pen.tilt_x = sample.pen.tilt_y = 0;
  }
}

}  // namespace

bool is_inkml(std::string_view text) { return begins_with_element(text, "ink"); }

PenFile read_inkml(const PenFileText& file) { return InkmlReader(file).read(); }

}  // namespace burin
