#pragma once
#include <burin/host/brush_library.h>

#include <map>
#include <string>
#include <vector>

namespace burin {

/// The brushes of a library that a session has made, each once.
class CreatedBrushes {
 public:
  /// The library must outlive the object.
  explicit CreatedBrushes(const BrushLibrary& library) : library_(&library) {}

  const BrushLibrary& library() const { return *library_; }

  /// The brush of an entry. If its module was loaded anew the state of the brush before is carried over; what
  /// is lost of that is added to `warnings`. Throws Error where the module cannot make it.
  const burin_brush& brush(const BrushEntry& entry, std::vector<std::string>& warnings);

 private:
  /// Its descriptor is another one once its module was loaded anew.
  struct Created {
    const burin_brush_descriptor* descriptor = nullptr;
    BrushPtr brush;
  };

  const BrushLibrary* library_;
  std::map<std::string, Created, std::less<>> created_;  ///< by id
};

}  // namespace burin
