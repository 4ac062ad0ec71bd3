#pragma once
#include <burin/ink/pen_file.h>

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace burin {

/// A channel of a sensor in the Universal Ink Model, as its description has it.
struct UimChannel {
  std::string type;            ///< "will://input/3.0/channel/X"
  std::size_t group = 0;       ///< the same for channels that are measured together
  std::int64_t precision = 0;  ///< numbers are in steps of 10^-precision
  double resolution = 0;       ///< per metre, second or radian; 0 if unknown
  double most = 0;             ///< the greatest value, as the device tells it; 0 if unknown
  std::string_view tool;       ///< DrawnBy::tool
};

/// Channels by their ids.
using UimChannels = std::map<std::string, UimChannel, std::less<>>;

/// What one sensor measured between two contacts, or while hovering.
struct UimSensorData {
  bool hovering = false;
  double start = 0;  ///< seconds since 1970
  /// The numbers of each channel by its id: the first one, then differences.
  std::vector<std::pair<std::string, std::vector<std::int64_t>>> numbers;
};

/// Adds the stroke of a sensor's data to the file; hovering samples are only counted. Positions are pixels of
/// 1/96 inch. Data without X are those of something else than a pen. Throws Error for data with another
/// number of Y than of X.
void add_stroke(const UimSensorData& data, const UimChannels& channels, PenFile& file);

}  // namespace burin
