#pragma once
#include <burin/abi/ext/lettering.h>
#include <burin/plugin/stamps.h>

#include <cstdint>

namespace burin::plugin {

/// A line of text as a stamp that is 1 inside letters and 0 outside. A member of a brush, like Stamp.
class Lettering {
 public:
  /// `font`: the path of a font file, or the file name of a system font. `em`: texels per em, 8 .. 512.
  /// Throws Error if the host cannot set text, the font does not exist or it lacks a character.
  Lettering(const Host& host, const char* font, const char* text, std::uint32_t em)
      : stamp_(host, [&](const burin_stamps&, burin_stamp* stamp, burin_stamp_info*, burin_text* error) {
          const auto* lettering = host.service<burin_lettering>(BURIN_EXT_LETTERING);
          if (!lettering) throw Error("this host cannot set text", BURIN_UNSUPPORTED);
          info_.struct_size = sizeof info_;
          return lettering->set(host.raw(), font, text, em, stamp, &info_, error);
        }) {}

  /// The measures of the line, in ems.
  const burin_lettering_info& info() const { return info_; }
  const Stamp& stamp() const { return stamp_; }  ///< the line of text as an image

  /// The position in the stamp of the point x ems to the right of the line's start and y ems above its
  /// baseline.
  StampPoint point_at(float x, float y) const {
    return {(x - info_.left) / (info_.right - info_.left), (info_.top - y) / (info_.top - info_.bottom)};
  }

 private:
  burin_lettering_info info_{};
  Stamp stamp_;
};

}  // namespace burin::plugin
