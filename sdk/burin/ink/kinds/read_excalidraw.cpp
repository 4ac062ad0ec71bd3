// Reads scenes and libraries of Excalidraw: JSON with elements, of which those drawn by hand ("freedraw") are
// strokes. Points lie relative to the element, which then turns about the middle of their box. Positions are
// CSS pixels. Pressures that the program simulates are not in the file.
#include <burin/base/text/json_value.h>
#include <burin/ink/kinds/kinds.h>
#include <burin/ink/parse/json_parts.h>
#include <burin/ink/parse/pen_json.h>
#include <burin/ink/parse/scan.h>
#include <burin/ink/pen_file.h>
#include <burin/math/elementary.h>

#include <Eigen/Geometry>

#include <nlohmann/json.hpp>
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

void read_pressures(const JsonValue& element, PenStroke& stroke) {
  const auto list = element.find("pressures");
  if (!list || list->size() == 0) return;
  const std::vector<double> pressures = list->numbers();
  if (pressures.size() != stroke.samples.size()) list->reject("points and pressures differ in their count");
  stroke.fields.pressure = true;
  stroke.made_pressure = is_set(element, "simulatePressure");
  for (std::size_t i = 0; i < pressures.size(); ++i)
    stroke.samples[i].pen.pressure = static_cast<float>(pressures[i]);
}

PenStroke stroke_of(const JsonValue& element) {
  const double x = element.member("x").number(), y = element.member("y").number();
  PenStroke stroke;
  for (const JsonValue& point : element.member("points").items()) {
    if (!point.is_array() || point.size() < 2) point.reject_type("a list of x and y");
    stroke.samples.push_back(
        {.time = 0, .position = {x + point.number_at(0), y + point.number_at(1), 0}, .pen = {}});
  }
  if (const double angle = number_or_0(element, "angle"); angle != 0) turn(stroke.samples, angle);
  read_pressures(element, stroke);
  return stroke;
}

void read_element(const JsonValue& element, std::size_t page, PenFile& content) {
  if (!element.is_object()) element.reject_type("an element");
  const auto type = element.find("type");
  if (!type || !type->is_text() || type->text() != "freedraw" || is_set(element, "isDeleted")) return;
  PenStroke stroke = stroke_of(element);
  stroke.page = page;
  if (!stroke.samples.empty()) content.strokes.push_back(std::move(stroke));
}

void read_elements(const JsonValue& elements, std::size_t page, PenFile& content) {
  for (const JsonValue& element : elements.items()) read_element(element, page, content);
}

/// Reads a scene element by element. Returns false for a library and whatever else is to be read as a whole.
bool read_scene(const PenFileText& file, PenFile& content) {
  bool scene = false;
  return for_each_json_part(file.text,
                            [&](std::string_view name, std::string_view part) {
                              if (name != "elements")
                                return !name.starts_with("library") && nlohmann::json::accept(part);
                              scene = true;
                              return for_each_json_part(
                                  part, [&](std::string_view, std::string_view element) {
                                    read_element(pen_json_part(file, element), 1, content);
                                    return true;
                                  });
                            }) &&
         scene;
}

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
  if (auto scene = pen_file_by_parts([&](PenFile& to) { return read_scene(file, to); })) {
    content = std::move(*scene);
  } else {
    const JsonValue root = pen_json(file);
    if (const auto items = root.find("libraryItems"))
      for (const JsonValue& item : items->items()) read_elements(item.member("elements"), ++page, content);
    else if (const auto library = root.find("library"))
      for (const JsonValue& elements : library->items()) read_elements(elements, ++page, content);
    else
      read_elements(root.member("elements"), 1, content);
  }
  content.unit = "px";
  content.millimetres = millimetres_a_pixel;
  return content;
}

}  // namespace burin
