#pragma once
#include <burin/ink/pen_file.h>

#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>

namespace burin {

/// An XML file. Entities that the file declares itself are not expanded, and nothing outside of it is read.
class XmlFile {
 public:
  /// Throws FileError that names the line of malformed XML, and for nesting deeper than 200 elements; for
  /// more than 500,000 tags or attributes, or one of 32 bytes, before anything is parsed.
  explicit XmlFile(const PenFileText& file);

  pugi::xml_node root() const { return document_.document_element(); }

  /// Throws FileError that names the line of the element.
  [[noreturn]] void reject(const pugi::xml_node& node, std::string_view what) const;

 private:
  std::string place(std::ptrdiff_t offset) const;

  const PenFileText& file_;
  pugi::xml_document document_;
};

/// Whether the first element of a text has this name, of any namespace. Comments, declarations and blanks may
/// come before it.
bool begins_with_element(std::string_view text, std::string_view name);

/// A name without its prefix.
std::string_view local_name(const char* name);

/// The attribute of this name, with whatever prefix; an empty one if there is none.
pugi::xml_attribute attribute(const pugi::xml_node& node, std::string_view name);

/// The number at the front of an attribute's value; nothing if there is none.
std::optional<double> number_of(const pugi::xml_attribute& attribute);

/// The text of an element, whatever comments or CDATA part it. A text in several parts is put together in
/// `joined`, which must outlive it.
std::string_view text_of(const pugi::xml_node& node, std::string& joined);

/// The first child element of this name, with whatever prefix; an empty one if there is none.
pugi::xml_node child(const pugi::xml_node& node, std::string_view name);

}  // namespace burin
