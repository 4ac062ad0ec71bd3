// Collects the formats of traces in an InkML file: those of traceFormat elements, and through them those of
// the contexts and sources around them; and the brushes of traces.
#include <burin/base/error.h>
#include <burin/base/text/quoted_word.h>
#include <burin/ink/decode/inkml_format.h>
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

namespace burin {
namespace {

InkmlChannel channel_of(const pugi::xml_node& node) {
  return {.name = attribute(node, "name").value(),
          .units = attribute(node, "units").value(),
          .least = number_of(attribute(node, "min")),
          .most = number_of(attribute(node, "max")),
          .otherwise = number_of(attribute(node, "default")),
          .boolean = std::string_view(attribute(node, "type").value()) == "boolean",
          .reversed = std::string_view(attribute(node, "orientation").value()) == "-ve",
          .resolution = 0,
          .resolution_units = {}};
}

InkmlFormat format_of(const pugi::xml_node& node) {
  InkmlFormat format;
  for (const pugi::xml_node& one : node.children())
    if (local_name(one.name()) == "channel") format.channels.push_back(channel_of(one));
  format.regular = format.channels.size();
  for (const pugi::xml_node& one : child(node, "intermittentChannels").children())
    if (local_name(one.name()) == "channel") format.channels.push_back(channel_of(one));
  return format;
}

void add_properties(InkmlFormat& format, const pugi::xml_node& properties) {
  for (const pugi::xml_node& property : properties.children()) {
    const std::string_view of = attribute(property, "channel").value();
    const auto channel = std::ranges::find(format.channels, of, &InkmlChannel::name);
    if (channel == format.channels.end() ||
        std::string_view(attribute(property, "name").value()) != "resolution")
      continue;
    channel->resolution = number_of(attribute(property, "value")).value_or(0);
    channel->resolution_units = attribute(property, "units").value();
  }
}

DrawnBy drawn_by(const pugi::xml_node& brush) {
  DrawnBy made;
  for (const pugi::xml_node& property : brush.children()) {
    const std::string_view name = attribute(property, "name").value(),
                           value = attribute(property, "value").value();
    if (name == inkml_tool_property) made.tool = value;
    if (name == inkml_eraser_property) made.eraser = value == "true";
  }
  return made;
}

std::string id_of(const pugi::xml_node& node) { return attribute(node, "id").value(); }

}  // namespace

std::string InkmlFormats::reference_of(const pugi::xml_node& context) {
  const std::string id = id_of(context);
  // No id begins with a number sign.
  return id.empty() ? fmt::format("##{}", context.offset_debug()) : "#" + id;
}

InkmlFormats::InkmlFormats(const XmlFile& file) : file_(file) {
  collect(file.root());
  const bool says_plain = !plain_.channels.empty();
  if (!says_plain) plain_ = {{InkmlChannel{.name = "X"}, InkmlChannel{.name = "Y"}}, 2};
  for (auto& [id, format] : formats_)
    if (format.channels.empty()) format = plain_;
  // Some writers leave it at saying one format, with an id, which no trace names.
  if (!says_plain && said_.size() == 1) plain_ = formats_.at(said_.front());
}

/// An element that has a format, or names one that came before, gives it to those around it: a source to its
/// context.
void InkmlFormats::collect(const pugi::xml_node& node) {
  const std::string_view name = local_name(node.name());
  if (name == "trace") return;
  if (name == "traceFormat") {
    InkmlFormat format = format_of(node);
    if (format.channels.empty()) return;
    const pugi::xml_node around = node.parent();
    const bool of_source = local_name(around.name()) == "inkSource";
    if (of_source) add_properties(format, child(around, "channelProperties"));
    const pugi::xml_node context = of_source ? around.parent() : around;
    for (const pugi::xml_node& one : {node, around, context}) formats_[reference_of(one).substr(1)] = format;
    said_.push_back(reference_of(node).substr(1));
    if (plain_.channels.empty() && id_of(node).empty() && id_of(around).empty()) plain_ = format;
    return;
  }
  if (name == "context") take_references(node);
  for (const pugi::xml_node& one : node.children()) collect(one);
}

/// A context without a format of its own has that of what it names, or the plain one.
void InkmlFormats::take_references(const pugi::xml_node& context) {
  InkmlFormat format;
  for (const char* reference : {"traceFormatRef", "inkSourceRef", "contextRef"}) {
    std::string_view to = attribute(context, reference).value();
    to.remove_prefix(to.starts_with('#') ? 1 : 0);
    if (const auto found = formats_.find(to); found != formats_.end()) format = found->second;
  }
  formats_[reference_of(context).substr(1)] = format;
}

const InkmlFormat& InkmlFormats::of(const pugi::xml_node& node, std::string_view reference) const {
  if (reference.empty()) return plain_;
  const std::string_view id = reference.substr(reference.starts_with('#') ? 1 : 0);
  const auto found = formats_.find(id);
  if (found == formats_.end()) {
    const auto named = [](const auto& one) { return !one.first.starts_with('#'); };
    if (std::ranges::any_of(formats_, named))
      file_.reject(node, fmt::format("names {}, which has no format", quoted_word(reference)));
    return plain_;
  }
  return found->second;
}

InkmlBrushes::InkmlBrushes(const XmlFile& file) {
  Named named;
  collect(file.root(), named);
  for (const pugi::xml_node& brush : named.brushes) brushes_["#" + id_of(brush)] = drawn_by(brush);
  for (const pugi::xml_node& context : named.contexts)
    brushes_[InkmlFormats::reference_of(context)] = of_context(context);
}

void InkmlBrushes::collect(const pugi::xml_node& node, Named& named) {
  for (const pugi::xml_node& one : node.children()) {
    const std::string_view name = local_name(one.name());
    if (name == "brush") named.brushes.push_back(one);
    if (name == "context") named.contexts.push_back(one);
    if (name != "trace") collect(one, named);
  }
}

/// The brush in a context or that it names, else that of the context that it names, which came before.
DrawnBy InkmlBrushes::of_context(const pugi::xml_node& context) const {
  if (const pugi::xml_node own = child(context, "brush")) return drawn_by(own);
  const pugi::xml_attribute brush = attribute(context, "brushRef");
  return of(brush ? brush.value() : attribute(context, "contextRef").value());
}

DrawnBy InkmlBrushes::of(std::string_view reference) const {
  const auto found = brushes_.find(reference);
  return found == brushes_.end() ? DrawnBy{} : found->second;
}

}  // namespace burin
