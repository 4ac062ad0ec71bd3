// Reads the paths, lines and polylines of SVG pictures, in the pixels of the picture, with the transforms and
// views around them. Each subpath is a stroke. A picture has no times, pressure or tilt; curves give chords,
// see svg_path.h.
#include <burin/base/error.h>
#include <burin/ink/decode/svg_path.h>
#include <burin/ink/kinds/kinds.h>
#include <burin/ink/parse/svg_element.h>
#include <burin/ink/parse/svg_styles.h>
#include <burin/ink/parse/svg_transform.h>
#include <burin/ink/parse/xml.h>
#include <burin/ink/pen_file.h>
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace burin {
namespace {

/// Whether elements show something that is no line of a pen.
bool is_other_shape(std::string_view name) {
  constexpr std::array<std::string_view, 5> others = {"circle", "ellipse", "image", "rect", "text"};
  return std::ranges::find(others, name) != others.end();
}

bool serves_by_reference(std::string_view name) {
  constexpr std::array<std::string_view, 6> names = {"clipPath", "defs",    "marker",
                                                     "mask",     "pattern", "symbol"};
  return std::ranges::find(names, name) != names.end();
}

/// Where and how an element is shown.
struct Shown {
  Eigen::Affine2d transform = Eigen::Affine2d::Identity();
  bool visible = true;    ///< unless the element says otherwise
  std::size_t depth = 0;  ///< within other elements, through those that `use` shows
  pugi::xml_node use;     ///< whose reference is to this very element; an empty one if none is
};

class SvgReader {
 public:
  explicit SvgReader(const PenFileText& file)
      : xml_(file),
        most_samples_(always_samples + samples_a_byte * file.text.size()),
        most_work_(always_work + work_a_byte * file.text.size()) {
    content_.unit = "px";
  }

  PenFile read() {
    apply_styles();
    read_element(xml_.root(), Shown());
    content_.not_used.assign(others_.begin(), others_.end());
    return std::move(content_);
  }

 private:
  // What `use` repeats could be without end: points, and the work of reading elements once more, in bytes.
  static constexpr std::size_t always_samples = 100'000, samples_a_byte = 16, always_work = 2'000'000,
                               work_a_byte = 32, deepest = 300;

  void apply_styles();
  void charge(const pugi::xml_node& node, std::size_t depth);
  bool read_element(const pugi::xml_node& node, Shown shown);
  void read_children(const pugi::xml_node& node, const Shown& shown);
  void read_used(const pugi::xml_node& node, Shown shown);
  pugi::xml_node element_of(std::string_view id);
  void add_shape(const pugi::xml_node& node, const Eigen::Affine2d& transform);
  void add_path(std::string_view data, const Eigen::Affine2d& transform);

  XmlFile xml_;
  std::size_t most_samples_, samples_ = 0, most_work_, work_ = 0;
  std::optional<std::map<std::string_view, pugi::xml_node>> elements_;  ///< by id, once one is used
  std::set<std::string> others_;  ///< names of elements that show something else
  PenFile content_;
};

void SvgReader::apply_styles() {
  try {
    apply_svg_style_sheets(xml_.root());
  } catch (const Error& error) {
    xml_.reject(xml_.root(), error.what());
  }
}

/// Counts an element that is read. Throws Error for too much.
void SvgReader::charge(const pugi::xml_node& node, std::size_t depth) {
  constexpr std::size_t tag = 16;  // takes as long as this many bytes of a path
  if (depth > deepest)
    throw Error(fmt::format("nested deeper than {} elements, with those that use shows", deepest));
  work_ += tag;
  for (const pugi::xml_attribute& attribute : node.attributes())
    work_ += tag + std::string_view(attribute.value()).size();
  if (work_ > most_work_) throw Error("more elements shown again than a file of this size may have");
}

/// Takes an element and those in it, if it applies, which it returns. What only serves others by reference is
/// no stroke.
bool SvgReader::read_element(const pugi::xml_node& node, Shown shown) {
  const std::string_view name = local_name(node.name());
  try {
    charge(node, shown.depth);
    if (!svg_applies(node)) return false;
    if (svg_word(node, "display") == "none") return true;
    if (const std::string_view own = svg_word(node, "visibility"); !own.empty() && own != "inherit")
      shown.visible = own == "visible";
    if (serves_by_reference(name) && !(name == "symbol" && shown.use)) return true;
    shown.transform = shown.transform * svg_transform_of(node);
    if (name == "svg" || name == "symbol") shown.transform = shown.transform * svg_view(node, shown.use);
    shown.use = {};
    if (shown.visible) add_shape(node, shown.transform);
    if (shown.visible && is_other_shape(name)) others_.insert(std::string(name));
    ++shown.depth;
    if (name == "use") {
      read_used(node, shown);
      return true;
    }
  } catch (const FileError&) {
    throw;
  } catch (const Error& error) {
    xml_.reject(node, error.what());
  }
  read_children(node, shown);
  return true;
}

/// Takes all elements in an element, or of a `switch` only the first that applies.
void SvgReader::read_children(const pugi::xml_node& node, const Shown& shown) {
  const bool one = local_name(node.name()) == "switch";
  for (const pugi::xml_node& child : node.children()) {
    if (child.type() == pugi::node_element && read_element(child, shown) && one) return;
  }
}

/// Takes the element that a `use` shows again, moved to its x and y, instead of those in the `use`.
void SvgReader::read_used(const pugi::xml_node& node, Shown shown) {
  const std::string_view reference = attribute(node, "href").value();
  const pugi::xml_node used = reference.starts_with('#') ? element_of(reference.substr(1)) : pugi::xml_node();
  if (!used) return;
  const auto coordinate = [&](const char* axis) { return pixels(attribute(node, axis).value()).value_or(0); };
  shown.transform.translate(Eigen::Vector2d(coordinate("x"), coordinate("y")));
  shown.use = node;
  read_element(used, shown);
}

pugi::xml_node SvgReader::element_of(std::string_view id) {
  if (!elements_) {
    elements_.emplace();
    xml_.root().find_node([this](const pugi::xml_node& node) {
      if (const std::string_view own = node.attribute("id").value(); !own.empty())
        elements_->try_emplace(own, node);
      return false;
    });
  }
  const auto found = elements_->find(id);
  return found == elements_->end() ? pugi::xml_node() : found->second;
}

void SvgReader::add_shape(const pugi::xml_node& node, const Eigen::Affine2d& transform) {
  const std::string_view name = local_name(node.name());
  if (name == "path") add_path(attribute(node, "d").value(), transform);
  if (name == "polyline" || name == "polygon") {
    const std::string points = attribute(node, "points").value();
    if (!points.empty()) add_path("M" + points + (name == "polygon" ? "Z" : ""), transform);
  }
  if (name == "line") {
    const auto end = [&](const char* axis) { return pixels(attribute(node, axis).value()).value_or(0); };
    add_path(fmt::format("M{} {}L{} {}", end("x1"), end("y1"), end("x2"), end("y2")), transform);
  }
}

void SvgReader::add_path(std::string_view data, const Eigen::Affine2d& transform) {
  follow_svg_path(
      data, [&] { content_.strokes.emplace_back(); },
      [&](const Eigen::Vector2d& point) {
        if (++samples_ > most_samples_) throw Error("more points than a file of this size may show");
        Sample& sample = content_.strokes.back().samples.emplace_back();
        sample.position.head<2>() = transform * point;
      });
}

}  // namespace

bool is_svg(std::string_view text) { return begins_with_element(text, "svg"); }

PenFile read_svg(const PenFileText& file) { return SvgReader(file).read(); }

}  // namespace burin
