#pragma once
#include <burin/ink/parse/xml.h>

namespace burin {

/// Gives the elements of a picture, before the declarations of their own `style`, what its style sheets say
/// of whether and where they are shown. Of selectors those are known that are the name of an element, a
/// class, an element's name with a class, or an id. Throws Error for sheets that say far too much.
void apply_svg_style_sheets(const pugi::xml_node& root);

}  // namespace burin
