#pragma once
#include <burin/surface/files/text_lines.h>
#include <burin/surface/polygon_mesh.h>

#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// The tags of a subdivision surface in an OBJ file, in the format of OpenSubdiv's regression shapes: `t NAME
/// I/R/S`, then I integers, R real numbers and S words.
///
/// - `crease 2/1/0 a b sharpness`: several pairs are allowed, with one sharpness for all, one per pair, or
/// one per
///   vertex, of which that of a pair's first vertex counts
/// - `corner 1/1/0 v sharpness`: several vertices are allowed, with one sharpness for all or one per vertex
/// - `hole 1/0/0 face`: several faces are allowed
/// - `interpolateboundary 1/0/0 rule`: 0 no boundary faces, 1 edges and corners, 2 edges only
/// - `creasemethod 0/0/1 method`: normal or chaikin
///
/// Vertices and faces are counted from 0, over the whole file, regardless of groups.
class ObjTags {
 public:
  /// Parses the rest of a line after the `t`. Returns an error message, or an empty string.
  std::string take(std::string_view line, std::size_t number);

  /// The number of tags of kinds that a PolygonMesh does not hold.
  std::size_t unknown() const { return unknown_; }

  /// Stores all tags in a mesh whose faces are complete and which has this many vertices. Returns an error
  /// message and sets `number` to its line, or returns an empty string.
  std::string give(PolygonMesh& mesh, std::size_t vertices, std::size_t& number) const;

 private:
  struct Tag {
    std::string name;
    std::vector<long long> integers;
    std::vector<double> reals;
    std::vector<std::string> words;
    std::size_t line = 0;
  };

  std::vector<Tag> tags_;
  std::size_t unknown_ = 0;
};

}  // namespace burin
