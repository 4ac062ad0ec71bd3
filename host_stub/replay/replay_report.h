#pragma once
#include <string>

#include "replay/replay_pictures.h"
#include "replay/replay_summary.h"

namespace burin {

/// Writes before.png, after.png, chart.png, report.json (with the content `json`) and, last, index.html,
/// which shows them, to the folder, which is created if needed. Throws FileError.
void write_report(const std::string& folder, const ReplaySummary& summary, const Json& json,
                  const ReplayPictures& pictures);

}  // namespace burin
