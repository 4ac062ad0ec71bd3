// Reads the paths, lines and polylines of SVG pictures, in the pixels of the picture, with the transforms and
// views around them. Each subpath is a stroke. A picture has no times, pressure or tilt; curves give chords,
// see svg_path.h.
#include <burin/base/error.h>
#include <burin/base/text/quoted_word.h>
#include <burin/ink/decode/svg_path.h>
#include <burin/ink/kinds/kinds.h>
#include <burin/ink/parse/scan.h>
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

using Affine = Eigen::Affine2d;

/// Where preserveAspectRatio has one axis: at the start, the middle or the end of what is left over.
double share_before(std::string_view aspect, char axis) {
  const auto has = [&](std::string_view end) {
    return aspect.find(std::string(1, axis) + std::string(end)) != aspect.npos;
  };
  return has("Min") ? 0 : has("Max") ? 1 : 0.5;
}

/// Maps the viewBox of an `svg` or `symbol` element to its place (section 8.2). Without either it is the
/// identity. `use`: that shows it and may tell another size; an empty one if none does.
Affine view_of(const pugi::xml_node& svg, const pugi::xml_node& use) {
  Affine view = Affine::Identity();
  view.translate(Eigen::Vector2d(pixels(attribute(svg, "x").value()).value_or(0),
                                 pixels(attribute(svg, "y").value()).value_or(0)));
  const auto size = [&](const char* name) {
    const pugi::xml_attribute told = attribute(use, name);
    return pixels((told ? told : attribute(svg, name)).value());
  };
  const auto width = size("width"), height = size("height");
  const std::vector<double> box = numbers_of(attribute(svg, "viewBox").value());
  if (box.size() != 4 || !width || !height || !(box[2] > 0) || !(box[3] > 0)) return view;
  const std::string_view aspect = attribute(svg, "preserveAspectRatio").value();
  Eigen::Array2d scale(*width / box[2], *height / box[3]);
  if (aspect.find("none") == aspect.npos)
    scale = aspect.find("slice") == aspect.npos ? scale.minCoeff() : scale.maxCoeff();
  const Eigen::Array2d left_over = Eigen::Array2d(*width, *height) - scale * Eigen::Array2d(box[2], box[3]);
  view.translate((left_over * Eigen::Array2d(share_before(aspect, 'x'), share_before(aspect, 'Y'))).matrix());
  view.scale(scale.matrix());
  return view.translate(-Eigen::Vector2d(box[0], box[1]));
}

/// What an element says of a property, by its style or else by an attribute; empty if it says nothing.
std::string_view property_of(const pugi::xml_node& node, std::string_view name) {
  std::string_view value = attribute(node, name).value();
  for (std::string_view style = attribute(node, "style").value(); !style.empty();) {
    std::string_view declaration = style.substr(0, style.find(';'));
    style.remove_prefix(std::min(declaration.size() + 1, style.size()));
    skip_blanks(declaration);
    if (!declaration.starts_with(name)) continue;
    declaration.remove_prefix(name.size());
    if (take_character(declaration, ':')) value = declaration;
  }
  return value;
}

/// The same of a property that is one word.
std::string_view word_of(const pugi::xml_node& node, std::string_view name) {
  std::string_view value = property_of(node, name);
  return take_word(value);
}

/// The origin of an element's transform, that of the coordinates unless CSS says other. Behind one length CSS
/// takes the centre of what is shown for the other.
Eigen::Vector2d transform_origin(const pugi::xml_node& node) {
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  std::string_view place = property_of(node, "transform-origin");
  place = place.substr(0, place.find("!important"));
  skip_blanks(place);
  if (place.empty()) return origin;
  const std::string quoted = quoted_word(place);
  for (double& coordinate : origin) {
    const auto known = pixels(take_word(place));
    if (!known) throw Error(fmt::format("a transform-origin that is not two lengths: {}", quoted));
    coordinate = *known;
  }
  return origin;
}

/// The transform of an element, about its origin.
Affine transform_of(const pugi::xml_node& node) {
  std::string_view text = property_of(node, "transform");
  text = text.substr(0, text.find("!important"));
  std::string_view rest = text;
  const std::string_view word = take_word(rest);
  if (word.empty() || word == "none") return Affine::Identity();
  const Affine transform = parse_transform(text);
  const Eigen::Vector2d origin = transform_origin(node);
  return Eigen::Translation2d(origin) * transform * Eigen::Translation2d(-origin);
}

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
  Affine transform = Affine::Identity();
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
    read_element(xml_.root(), Shown());
    content_.not_used.assign(others_.begin(), others_.end());
    return std::move(content_);
  }

 private:
  // What `use` repeats could be without end: points, and the work of reading elements once more, in bytes.
  static constexpr std::size_t always_samples = 100'000, samples_a_byte = 16, always_work = 2'000'000,
                               work_a_byte = 32, deepest = 300;

  void charge(const pugi::xml_node& node, std::size_t depth);
  void read_element(const pugi::xml_node& node, Shown shown);
  void read_used(const pugi::xml_node& node, Shown shown);
  pugi::xml_node element_of(std::string_view id);
  void add_shape(const pugi::xml_node& node, const Affine& transform);
  void add_path(std::string_view data, const Affine& transform);

  XmlFile xml_;
  std::size_t most_samples_, samples_ = 0, most_work_, work_ = 0;
  std::optional<std::map<std::string_view, pugi::xml_node>> elements_;  ///< by id, once one is used
  std::set<std::string> others_;  ///< names of elements that show something else
  PenFile content_;
};

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

/// Takes an element and those in it. What only serves others by reference is no stroke.
void SvgReader::read_element(const pugi::xml_node& node, Shown shown) {
  const std::string_view name = local_name(node.name());
  try {
    charge(node, shown.depth);
    if (word_of(node, "display") == "none") return;
    if (const std::string_view own = word_of(node, "visibility"); !own.empty() && own != "inherit")
      shown.visible = own == "visible";
    if (serves_by_reference(name) && !(name == "symbol" && shown.use)) return;
    shown.transform = shown.transform * transform_of(node);
    if (name == "svg" || name == "symbol") shown.transform = shown.transform * view_of(node, shown.use);
    shown.use = {};
    if (shown.visible) add_shape(node, shown.transform);
    if (shown.visible && is_other_shape(name)) others_.insert(std::string(name));
    ++shown.depth;
    if (name == "use") return read_used(node, shown);
  } catch (const FileError&) {
    throw;
  } catch (const Error& error) {
    xml_.reject(node, error.what());
  }
  for (const pugi::xml_node& child : node.children()) read_element(child, shown);
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

void SvgReader::add_shape(const pugi::xml_node& node, const Affine& transform) {
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

void SvgReader::add_path(std::string_view data, const Affine& transform) {
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
