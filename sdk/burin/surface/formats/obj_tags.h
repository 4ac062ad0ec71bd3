#pragma once
#include <burin/surface/files/text_lines.h>
#include <burin/surface/polygon_mesh.h>

#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// The tags of a subdivision surface in an OBJ file, as OpenSubdiv's regression shapes have them:
/// `t NAME I/R/S`, then I integers, R real numbers and S words.
///
///   crease 2/1/0 a b sharpness       also several pairs, with one sharpness for all, one each or one a
///   vertex,
///                                    of which that of a pair's first counts
///   corner 1/1/0 v sharpness         also several, likewise
///   hole 1/0/0 face                  also several
///   interpolateboundary 1/0/0 rule   0 no boundary faces, 1 edges and corners, 2 edges only
///   creasemethod 0/0/1 method        normal or chaikin
///
/// Vertices and faces are counted from 0, in the whole file, whatever groups stand before.
class ObjTags {
 public:
  /// Takes what follows the `t` of a line. Returns what is wrong with it, or nothing.
  std::string take(std::string_view line, std::size_t number);

  /// How many tags are of kinds that no mesh keeps.
  std::size_t unknown() const { return unknown_; }

  /// Hands all to the mesh, whose vertices and faces are there: `vertices` of them. Returns what is wrong, or
  /// nothing, and sets `number` to its line.
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
