#pragma once
#include <burin/ink/parse/byte_reader.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace burin {

/// Property tags of packets that are read.
enum IsfProperty : std::uint64_t {
  isf_packet_status = 53,
  isf_pressure = 56,
  isf_tilt_x = 59,
  isf_tilt_y = 60,
  isf_azimuth = 61,
  isf_altitude = 62,
  isf_twist = 63
};

/// Units of angles.
enum IsfUnit : std::uint64_t { isf_degrees = 3, isf_radians = 4 };

/// What a packet of a stroke has.
struct IsfDescriptor {
  bool x = true, y = true;
  std::vector<std::uint64_t> properties;  ///< behind x and y
  std::size_t buttons = 0;                ///< bits for each packet behind its properties
  std::optional<std::size_t> barrel;      ///< which of the buttons is the one at the pen's side, from 0
};

/// Range and unit of a property. What a file does not tell is as isf_usual_metric() has it.
struct IsfMetric {
  std::int64_t least = 0, most = 0;
  std::uint64_t unit = 0;
  float precision = 0;  ///< numbers per unit; 0 if unknown
};

using IsfMetrics = std::map<std::uint64_t, IsfMetric>;  ///< by property

/// What writers leave out, as WPF has it: pressures to 1023, angles in tenths of a degree.
IsfMetric isf_usual_metric(std::uint64_t property);

/// What metrics tell of a property, or the usual.
IsfMetric isf_metric_of(const IsfMetrics& metrics, std::uint64_t property);

/// The tables of a stream, from which strokes choose by their index.
struct IsfTables {
  std::optional<std::uint64_t> barrel_tag;  ///< of the button at the pen's side, if the file gives it one
  std::vector<IsfDescriptor> descriptors;
  std::vector<Eigen::Affine2d> transforms;
  std::vector<IsfMetrics> metrics;
};

/// Reads the content of a tag into the tables, instead of what such a table had before. Returns false, and
/// reads nothing, for a tag of something else.
bool read_isf_table(std::uint64_t tag, ByteReader& stream, IsfTables& tables);

}  // namespace burin
