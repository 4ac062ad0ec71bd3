#pragma once
#include <burin/abi/ext/lettering.h>
#include <burin/plugin/stamps.h>

#include <cstdint>

namespace burin::plugin {

/// A line of text as a stamp that is 1 inside of letters; a member of a brush, as Stamp is.
class Lettering {
 public:
  /// `font`: path of a font file, or the name of one of the system's. `em`: texels to an em, 8 .. 512.
  /// Throws Error: the host sets no text, no such font, or a character that the font lacks.
  Lettering(const Host& host, const char* font, const char* text, std::uint32_t em)
      : stamp_(host, [&](const burin_stamps&, burin_stamp* stamp, burin_stamp_info*, burin_text* error) {
          const auto* lettering = host.service<burin_lettering>(BURIN_EXT_LETTERING);
          if (!lettering) throw Error("this host cannot set text", BURIN_UNSUPPORTED);
          info_.struct_size = sizeof info_;
          return lettering->set(host.raw(), font, text, em, stamp, &info_, error);
        }) {}

  /// Its measures, in ems.
  const burin_lettering_info& info() const { return info_; }
  const Stamp& stamp() const { return stamp_; }

  /// Of a place x ems right of where the line begins and y above its baseline.
  StampPlace place(float x, float y) const {
    return {(x - info_.left) / (info_.right - info_.left), (info_.top - y) / (info_.top - info_.bottom)};
  }

 private:
  burin_lettering_info info_{};
  Stamp stamp_;
};

}  // namespace burin::plugin
