#pragma once
#include <string>

#include "replay/replay_pictures.h"
#include "replay/replay_summary.h"

namespace burin {

/// Writes before.png, after.png, chart.png, report.json and, last, index.html, which shows them, into the
/// folder, creating it where needed. `json` is the content of report.json. Throws FileError.
void write_report(const std::string& folder, const ReplaySummary& summary, const Json& json,
                  const ReplayPictures& pictures);

}  // namespace burin
