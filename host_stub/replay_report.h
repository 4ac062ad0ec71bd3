#pragma once
#include <string>

#include "replay_pictures.h"
#include "replay_summary.h"

namespace burin {

/// Throws FileError when no folder can be at `folder`: a file stands there. An empty path is no report.
void check_report_folder(const std::string& folder);

/// Writes before.png, after.png, chart.png, report.json and, last, index.html, which shows them, into the
/// folder, creating it where needed. `json` is the content of report.json. Throws FileError.
void write_report(const std::string& folder, const ReplaySummary& summary, const Json& json,
                  const ReplayPictures& pictures);

}  // namespace burin
