#pragma once
#include <optional>
#include <string>
#include <vector>

#include "bench_brush/brush_times.h"
#include "bench_brush/drawn_stroke.h"
#include "system/console.h"

namespace burin {

/// A brush of the plugin beside all that it is compared with.
struct BrushReport {
  BrushTimes brush;
  std::optional<DrawnStroke> stroke;  ///< where a session could draw one
  std::optional<Estimate> against;    ///< its times as a multiple of the other version's
  struct Compared {
    std::string id;
    Estimate ratio;  ///< its times as a multiple of the stock brush's
  };
  std::vector<Compared> stock;

  /// Whether the times are what its author promised, within their interval.
  bool keeps_budget() const { return brush.budget == 0 || multiple_of(brush).low <= brush.budget; }
};

std::string brush_text(const BrushReport& report);
Json brush_json(const BrushReport& report);

/// Writes index.html with the strokes' pictures and bars of the ratios to a folder. Throws FileError.
void write_brush_page(const std::string& folder, const std::vector<BrushReport>& reports);

}  // namespace burin
