#pragma once
#include <burin/ink/parse/xml.h>
#include <burin/stroke/recording.h>

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// An annotation of this type and content tells that strokes lie in space. The recommendation has no such
/// strokes: its Z is the height of the pen above the paper.
inline constexpr std::string_view inkml_space_annotation = "space", inkml_object_space = "object";

/// Properties of brushes that write_inkml() gives to strokes whose tool is known; those of other programs
/// tell of colours and widths only.
inline constexpr std::string_view inkml_tool_property = "tool", inkml_eraser_property = "eraser";

/// What InkML says of a channel.
struct InkmlChannel {
  std::string name = {};   ///< "X", "F", "OTx"
  std::string units = {};  ///< "cm", "deg"; empty if not said
  std::optional<double> least = {}, most = {};
  std::optional<double> otherwise = {};  ///< the value of points that lack the channel
  bool boolean = false;
  bool reversed = false;              ///< grows against the axis that its name tells
  double resolution = 0;              ///< values per `resolution_units`; 0: not said
  std::string resolution_units = {};  ///< "1/cm"
};

/// The channels of a point, in their order.
struct InkmlFormat {
  std::vector<InkmlChannel> channels;
  std::size_t regular = 0;  ///< of these, those that all points have
};

/// The formats of an InkML file, by the ids of the elements that say them.
class InkmlFormats {
 public:
  explicit InkmlFormats(const XmlFile& file);

  /// The format that a reference "#id" names. Throws FileError that names the line of `node` if there is
  /// none.
  const InkmlFormat& of(const pugi::xml_node& node, std::string_view reference) const;

  /// The reference by which of() finds what a context says, whether it has an id or not.
  static std::string reference_of(const pugi::xml_node& context);

  /// The format of traces that name none: the first one that has no id, else the only one, or X and Y.
  const InkmlFormat& plain() const { return plain_; }

 private:
  void collect(const pugi::xml_node& node);
  void take_references(const pugi::xml_node& context);

  const XmlFile& file_;
  std::map<std::string, InkmlFormat, std::less<>> formats_;
  std::vector<std::string> said_;  ///< ids of formats
  InkmlFormat plain_;
};

/// What the brushes of an InkML file tell of tools.
class InkmlBrushes {
 public:
  explicit InkmlBrushes(const XmlFile& file);

  /// Of the brush, or of that of the context, that a reference "#id" names; nothing is known of others.
  DrawnBy of(std::string_view reference) const;

 private:
  /// What may be named before it stands, in the order of the file.
  struct Named {
    std::vector<pugi::xml_node> brushes, contexts;
  };
  static void collect(const pugi::xml_node& node, Named& named);
  DrawnBy of_context(const pugi::xml_node& context) const;

  std::map<std::string, DrawnBy, std::less<>> brushes_;  ///< by "#id"
};

}  // namespace burin
