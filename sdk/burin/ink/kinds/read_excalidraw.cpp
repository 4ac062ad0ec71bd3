// Reads scenes and libraries of Excalidraw: JSON with elements, of which those drawn by hand ("freedraw") are
// strokes; its first versions called them "draw". An item of a library is a list of elements, or an object
// that has one. Points lie relative to the element, which then turns about
// the middle of their box. Positions are CSS pixels. Pressures that the program simulates are not in the
// file.
#include <burin/base/text/json_value.h>
#include <burin/ink/kinds/kinds.h>
#include <burin/ink/parse/json_parts.h>
#include <burin/ink/parse/pen_json.h>
#include <burin/ink/parse/scan.h>
#include <burin/ink/pen_file.h>
#include <burin/math/elementary.h>

#include <Eigen/Geometry>

#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace burin {
namespace {

double number_or_0(const JsonValue& value, const char* name) {
  const auto found = value.find(name);
  return found ? found->number() : 0;
}

bool is_set(const JsonValue& value, const char* name) {
  const auto found = value.find(name);
  return found && found->is_boolean() && found->boolean();
}

/// Turns the samples clockwise about the middle of their box.
void turn(std::vector<Sample>& samples, double angle) {
  Eigen::AlignedBox2d box;
  for (const Sample& sample : samples) box.extend(sample.position.head<2>());
  const Eigen::Vector2d middle = box.center();
  const double cosine = math::cos(angle), sine = math::sin(angle);
  for (Sample& sample : samples) {
    const Eigen::Vector2d from = sample.position.head<2>() - middle;
    sample.position.head<2>() =
        middle + Eigen::Vector2d(cosine * from.x() - sine * from.y(), sine * from.x() + cosine * from.y());
  }
}

/// What is read of an element.
struct Element {
  bool freedraw = false, deleted = false, simulated = false;
  double x = 0, y = 0, angle = 0;
  std::vector<double> points;  ///< x and y of one after the other
  std::vector<double> pressures;
};

Element element_of(const JsonValue& json) {
  if (!json.is_object()) json.reject_type("an element");
  const auto type = json.find("type");
  Element element;
  element.freedraw = type && type->is_text() && (type->text() == "freedraw" || type->text() == "draw");
  element.deleted = is_set(json, "isDeleted");
  if (!element.freedraw || element.deleted) return element;
  element.x = json.member("x").number();
  element.y = json.member("y").number();
  element.angle = number_or_0(json, "angle");
  for (const JsonValue& point : json.member("points").items()) {
    if (!point.is_array() || point.size() < 2) point.reject_type("a list of x and y");
    element.points.insert(element.points.end(), {point.number_at(0), point.number_at(1)});
  }
  if (const auto list = json.find("pressures")) element.pressures = list->numbers();
  element.simulated = is_set(json, "simulatePressure");
  return element;
}

/// Appends x and y of each of a list of points. Returns false if it is anything else.
bool append_points(std::string_view json, std::vector<double>& points) {
  return for_each_json_part(json, [&](std::string_view, std::string_view point) {
    const std::size_t before = points.size();
    if (!append_numbers(point, points) || points.size() < before + 2) return false;
    points.resize(before + 2);
    return true;
  });
}

/// The same in a fraction of the time. Nothing for elements of other kinds, and of such faults as
/// element_of() names.
std::optional<Element> plain_element(std::string_view json) {
  Element element;
  const auto number = [](std::string_view part, double& value) {
    return take_number(part, value) && part.empty();
  };
  bool has_x = false, has_y = false;
  const bool plain = for_each_json_part(json, [&](std::string_view name, std::string_view part) {
    if (name == "x") return has_x = number(part, element.x);
    if (name == "y") return has_y = number(part, element.y);
    if (name == "angle") return number(part, element.angle);
    if (name == "points") return element.points.empty() && append_points(part, element.points);
    if (name == "pressures") return element.pressures.empty() && append_numbers(part, element.pressures);
    if (name == "type") element.freedraw = part == R"("freedraw")" || part == R"("draw")";
    if (name == "isDeleted") element.deleted = part == "true";
    if (name == "simulatePressure") element.simulated = part == "true";
    return nlohmann::json::accept(part);
  });
  const bool good = plain && element.freedraw && has_x && has_y;
  return good ? std::optional(std::move(element)) : std::nullopt;
}

void add_stroke(const Element& element, std::size_t page, PenFile& content) {
  if (!element.freedraw || element.deleted || element.points.empty()) return;
  PenStroke& stroke = content.strokes.emplace_back();
  stroke.page = page;
  stroke.samples.resize(element.points.size() / 2);
  for (std::size_t i = 0; i < stroke.samples.size(); ++i)
    stroke.samples[i].position = {element.x + element.points[2 * i], element.y + element.points[2 * i + 1],
                                  0};
  if (element.angle != 0) turn(stroke.samples, element.angle);
  // Some points may lack it.
  stroke.fields.pressure = element.pressures.size() >= stroke.samples.size();
  stroke.made_pressure = stroke.fields.pressure && element.simulated;
  for (std::size_t i = 0; stroke.fields.pressure && i < stroke.samples.size(); ++i)
    stroke.samples[i].pen.pressure = static_cast<float>(element.pressures[i]);
}

void read_elements(const JsonValue& elements, std::size_t page, PenFile& content) {
  for (const JsonValue& element : elements.items()) add_stroke(element_of(element), page, content);
}

/// Reads a file element by element.
class ByElements {
 public:
  ByElements(const PenFileText& file, PenFile& content) : file_(file), content_(content) {}

  /// Returns false for what must be read as a whole.
  bool read(TextWindow& text) {
    const bool whole = for_each_json_part(text, [this](std::string_view name, TextWindow& json) {
      const bool items = name == "libraryItems", lists = name == "library";
      if (name != "elements" && !items && !lists) return nlohmann::json::accept(take_json_value(json));
      ++lists_;
      if (!items && !lists) return read_list(json, 1);
      std::size_t page = 0;
      return for_each_json_part(json, [&](std::string_view, TextWindow& item) {
        item.skip_blanks();
        return item.text().starts_with('{') ? read_item(item, ++page) : read_list(item, ++page);
      });
    });
    return whole && lists_ == 1;
  }

 private:
  bool read_list(TextWindow& json, std::size_t page) {
    return for_each_json_part(json, [&](std::string_view, TextWindow& element) {
      const std::string_view part = take_json_value(element);
      const auto plain = plain_element(part);
      add_stroke(plain ? *plain : element_of(pen_json_part(file_, part)), page, content_);
      return true;
    });
  }

  bool read_item(TextWindow& json, std::size_t page) {
    int lists = 0;
    const bool whole = for_each_json_part(json, [&](std::string_view name, TextWindow& member) {
      if (name != "elements") return nlohmann::json::accept(take_json_value(member));
      ++lists;
      return read_list(member, page);
    });
    return whole && lists == 1;
  }

  const PenFileText& file_;
  PenFile& content_;
  int lists_ = 0;  ///< of elements or items that the file has; more than one need a rule which counts
};

}  // namespace

bool is_excalidraw(std::string_view text) {
  constexpr std::size_t early = 4096;
  skip_blanks(text);
  if (!text.starts_with('{')) return false;
  text = text.substr(0, early);
  return text.find("\"excalidraw\"") != text.npos || text.find("\"excalidrawlib\"") != text.npos ||
         text.find("\"excalidraw/clipboard\"") != text.npos;
}

PenFile read_excalidraw(const PenFileText& file) {
  PenFile content;
  std::size_t page = 0;
  const auto read = [&](TextWindow& text, PenFile& to) { return ByElements(file, to).read(text); };
  if (auto scene = pen_file_by_parts(file, read)) {
    content = std::move(*scene);
  } else {
    const JsonValue root = pen_json(file);
    const auto items = root.find("libraryItems"), library = items ? items : root.find("library");
    if (library)
      for (const JsonValue& item : library->items())
        read_elements(item.is_array() ? item : item.member("elements"), ++page, content);
    else
      read_elements(root.member("elements"), 1, content);
  }
  content.unit = "px";
  content.millimetres = millimetres_a_pixel;
  return content;
}

}  // namespace burin
