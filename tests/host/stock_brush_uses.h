#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "sessions.h"

namespace burin::test {

/// A brush and how it is used.
struct BrushUse {
  const char* id;
  ParamSettings params;      ///< without which it cannot draw, or draws something else
  const char* variant = "";  ///< letters that tell this use from others of the brush
};

/// Each stock brush in each of its forms. A brush that is missing here fails a test.
inline const std::vector<BrushUse> stock_brush_uses = {
    {"org.burin.arrow", {}},
    {"org.burin.bark", {}},
    {"org.burin.bead", {}},
    {"org.burin.bead", {{"form", std::string("beads")}}, "Beads"},
    {"org.burin.crease", {}},
    {"org.burin.dashed-line", {}},
    {"org.burin.flatten", {}},
    {"org.burin.groove", {}},
    {"org.burin.patterned-fill", {}},
    {"org.burin.patterned-fill", {{"pattern", std::string("hexagons")}}, "Hexagons"},
    {"org.burin.patterned-line", {}},
    {"org.burin.patterned-line", {{"figure", std::string("chain")}}, "Chain"},
    {"org.burin.pinch", {}},
    {"org.burin.rope", {}},
    {"org.burin.rope", {{"lay", std::string("plaited")}}, "Plaited"},
    {"org.burin.scales", {{"stamp", std::string(BURIN_SAMPLES "/stamps/scales.exr")}}},
    {"org.burin.smooth", {}},
    {"org.burin.stitches", {}},
    {"org.burin.stitches", {{"pattern", std::string("cross")}}, "Cross"},
    {"org.burin.text", {}},
    {"org.burin.tread", {{"stamp", std::string(BURIN_SAMPLES "/stamps/tread.exr")}}},
    {"org.burin.vdm-trail", {{"stamp", std::string(BURIN_SAMPLES "/stamps/thorn.exr")}}},
    {"org.burin.wave", {}},
};

/// The same of those that make solids and do nothing else.
inline const std::vector<BrushUse> solid_brush_uses = {
    {"org.burin.cable", {}},
    {"org.burin.carve", {}},
    {"org.burin.carve", {{"profile", std::string("slot")}, {"ends", std::string("flat")}}, "Slot"},
    {"org.burin.carve", {{"profile", std::string("round")}}, "Round"},
    {"org.burin.chain", {}},
    {"org.burin.rivets", {}},
    {"org.burin.screw", {}},
    {"org.burin.tube", {}},
    {"org.burin.tube", {{"wall", 0.3}, {"ends", std::string("flat")}}, "Pipe"},
    {"org.burin.tube", {{"profile", std::string("square")}}, "Square"},
    {"org.burin.tube", {{"profile", std::string("star")}}, "Star"},
    {"org.burin.vdb-trail", {{"stamp", std::string(BURIN_SAMPLES "/solids/rail.vdb")}}},
    {"org.burin.zipper", {}},
};

inline std::string name_of_use(const testing::TestParamInfo<BrushUse>& use) {
  std::string name = std::string(use.param.id).substr(std::string("org.burin.").size());
  std::replace(name.begin(), name.end(), '-', '_');
  return name + use.param.variant;
}

}  // namespace burin::test
