// Stroke settings, described once. A new one is a member of StrokeSettings or ReplaySettings, a row here, and
// its use. Tests compare the command line, suites, recordings and documents with the rows.
#include <burin/stroke/files/setting_table.h>
#include <burin/stroke/files/setting_values.h>
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

namespace burin {
namespace {

using Json = nlohmann::ordered_json;
using S = ReplaySettings;

constexpr std::uint64_t most_copies = 128, most_shown = 1000000;

/// What holds where nobody sets anything.
const S defaults;

std::string number_text(double number) { return fmt::format("{:g}", number); }

/// A row whose value is one member, which `read` makes of JSON.
template <class T, class Owner, class Read>
SettingRow member_row(SettingRow row, T Owner::*member, const Read& read) {
  row.read = [member, read](const JsonValue& value, GivenSettings& into) { into[member] = read(value); };
  if constexpr (requires(const T& value) { json_of(value); }) {
    row.write = [member, key = row.key](const GivenSettings& given, Json& into) {
      if (const T* value = given.find(member)) into[key] = json_of(*value);
    };
  }
  return row;
}

template <class Owner>
SettingRow number_row(SettingRow row, double Owner::*member, double (*read)(const JsonValue&)) {
  row.form = SettingForm::number;
  if (row.values.empty()) row.values = "a number";
  if (row.typed.empty()) row.typed = "NUMBER";
  return member_row(std::move(row), member, read);
}

SettingRow share_row(SettingRow row, double StrokeSettings::*member) {
  row.values = "0 to 1";
  row.typed = "0..1";
  row.initial = number_text(defaults.*member);
  return number_row(std::move(row), member, read_share);
}

/// A row of names, of which a default is one.
template <class Names>
SettingRow named_row(SettingRow row, const Names& names) {
  for (const auto& one : names) {
    row.values += fmt::format("{}`{}`", row.values.empty() ? "" : ", ", one.name);
    row.typed += fmt::format("{}{}", row.typed.empty() ? "" : "|", one.name);
  }
  return row;
}

template <class T, class Owner, class Names>
SettingRow choice_row(SettingRow row, T Owner::*member, const Names& names) {
  if constexpr (requires { name_of(names, defaults.*member); })
    row.initial = name_of(names, defaults.*member);
  return member_row(named_row(std::move(row), names), member,
                    [&names](const JsonValue& value) { return read_choice(value, names); });
}

/// A row of a part of the symmetry.
template <class Read>
SettingRow symmetry_row(SettingRow row, const Read& read) {
  row.read = [read](const JsonValue& value, GivenSettings& into) {
    read(value, into[&StrokeSettings::symmetry]);
  };
  return row;
}

std::vector<SettingRow> basic_rows() {
  return {
      member_row({.key = "brush", .help = "the brush", .values = "its id", .typed = "ID", .recorded = true},
                 &S::brush, [](const JsonValue& value) { return value.text(); }),
      number_row({.key = "radius",
                  .help = "half the width of the stroke",
                  .values = "a number above 0",
                  .typed = "NUMBER > 0",
                  .unit = "object units",
                  .recorded = true},
                 &S::radius, read_radius),
      number_row({.key = "strength",
                  .help = "factor on what the brush does",
                  .initial = number_text(defaults.strength),
                  .recorded = true},
                 &S::strength, read_finite),
      member_row({.key = "params",
                  .option = "--param",
                  .help = "parameters of the brush by their ids",
                  .values = "true or false, a number, a text or numbers each",
                  .typed = "NAME=VALUE",
                  .initial = "the brush's defaults",
                  .form = SettingForm::params,
                  .recorded = true},
                 &S::params, read_params),
      member_row(
          {.key = "dynamics",
           .option = "--dynamic",
           .help = "what varies radius, strength or a dynamic parameter along the stroke: multiplied by "
                   "(an angle: plus) what the curve makes of " +
                   source_names(),
           .values = "a list of `{\"target\", \"source\", \"curve\": [x0, y0, x1, y1, ...]}`",
           .typed = "TARGET=SOURCE:X0,Y0,X1,Y1,...",
           .initial = "none",
           .form = SettingForm::dynamics,
           .recorded = true},
          &S::dynamics, read_dynamics),
      share_row(
          {.key = "follow",
           .help = "how much of the relief the stroke feels, from what is wider than the brush to every "
                   "bump",
           .recorded = true},
          &S::follow),
      share_row({.key = "pressure_width", .help = "share of the width that the pen's pressure decides"},
                &S::pressure_width)};
}

SettingRow closed_row() {
  SettingRow row = named_row({.key = "closed",
                              .help = "whether the stroke goes around; auto: where the pen came back",
                              .initial = "no",
                              .recorded = true},
                             named_closures);
  row.values += ", true or false";
  return member_row(std::move(row), &S::closure, read_closure);
}

std::vector<SettingRow> shape_rows() {
  return {
      closed_row(),
      choice_row({.key = "cap", .help = "how the stroke ends"}, &S::cap, named_caps),
      choice_row({.key = "join", .help = "what happens where the stroke bends sharper than its radius"},
                 &S::join, named_joins),
      choice_row({.key = "overlap",
                  .help = "what holds where the stroke overlaps itself",
                  .initial = "as the brush says"},
                 &S::overlap, named_overlaps),
      choice_row({.key = "accumulate",
                  .help = "what the stroke starts from where it comes to a place again: the surface before "
                          "it, or what it has made of it"},
                 &S::accumulate, named_accumulations),
      member_row({.key = "clamp",
                  .help = "let no vertex go farther than one radius",
                  .values = "true or false",
                  .initial = "false",
                  .form = SettingForm::flag},
                 &S::clamp_to_radius, [](const JsonValue& value) { return value.boolean(); }),
      number_row({.key = "dabs",
                  .help = "draw a row of dabs so far apart instead of one stroke",
                  .values = fmt::format("a number of at least {:g}", least_dab_spacing),
                  .unit = "radii",
                  .initial = "one stroke"},
                 &S::dab_spacing, [](const JsonValue& value) {
                   if (const double apart = read_finite(value); apart >= least_dab_spacing) return apart;
                   value.reject_type(fmt::format("a number of at least {:g}", least_dab_spacing));
                 })};
}

std::vector<SettingRow> surface_rows() {
  return {member_row({.key = "refine",
                      .help = fmt::format("split triangles that are too large for the stroke, into edges of "
                                          "this length; auto: of radius / {:g}, where the mesh has gaps of "
                                          "more than radius / {:g} between vertices; or until it is off by "
                                          "at most this share of the stroke's height",
                                          Refining::fine, Refining::coarse),
                      .values = fmt::format("`auto`, `off`, `edge:LENGTH` or a text of {:g} to {:g}",
                                            Refining::least_error, Refining::most_error),
                      .typed = "auto|off|edge:LENGTH|SHARE",
                      .initial = "auto of replay, unless it bakes or sculpts a level; else off"},
                     &S::refining, read_refining)};
}

std::vector<SettingRow> solid_rows() {
  return {choice_row({.key = "solid",
                      .help = "what becomes of the solid that the brush makes along the stroke",
                      .initial = "separate, if the brush does nothing else"},
                     &S::solid, named_solids),
          number_row({.key = "voxel",
                      .help = "edge of the solid's voxels",
                      .values = "a number above 0",
                      .typed = "NUMBER > 0",
                      .unit = "object units",
                      .initial = "as fine as the brush's solid needs"},
                     &S::voxel, read_radius),
          number_row({.key = "blend",
                      .help = "radius of the fillet where a solid and the surface meet",
                      .values = "a number from 0",
                      .typed = "NUMBER >= 0",
                      .unit = "object units",
                      .initial = "0"},
                     &S::blend, read_not_negative)};
}

/// A row of a part of the meshes along the stroke, which decides nothing without one.
template <class Read>
SettingRow along_row(SettingRow row, const Read& read) {
  if (row.key != "along_mesh") row.needs = "along_mesh";
  row.read = [read](const JsonValue& value, GivenSettings& into) {
    read(value, into[&StrokeSettings::along]);
  };
  return row;
}

SettingRow along_file_row(SettingRow row, MeshSource AlongSettings::*source) {
  row.values = "a file";
  row.typed = "FILE";
  return along_row(std::move(row), [source](const JsonValue& value, AlongSettings& into) {
    into.*source = {{}, value.text()};
  });
}

SettingRow along_number_row(SettingRow row, double AlongSettings::*member, double (*read)(const JsonValue&)) {
  row.form = SettingForm::number;
  if (row.values.empty()) row.values = "a number";
  if (row.typed.empty()) row.typed = "NUMBER";
  return along_row(std::move(row), [member, read](const JsonValue& value, AlongSettings& into) {
    into.*member = read(value);
  });
}

std::vector<SettingRow> along_rows() {
  return {along_file_row({.key = "along_mesh",
                          .help = "bend copies of this mesh along the stroke, instead of what a brush does",
                          .initial = "none"},
                         &AlongSettings::middle),
          along_file_row(
              {.key = "along_start", .help = "bend this mesh to the start of the stroke", .initial = "none"},
              &AlongSettings::start),
          along_file_row(
              {.key = "along_end", .help = "bend this mesh to the end of the stroke", .initial = "none"},
              &AlongSettings::end),
          along_row({.key = "along_axes",
                     .help = "axes of these meshes that run along the stroke and up",
                     .values = "two of `x`, `y`, `z`, `-x`, `-y` and `-z`: `-z,y`",
                     .typed = "FORWARD,UP",
                     .initial = "x,y"},
                    read_axes),
          along_number_row({.key = "along_spacing",
                            .help = "from copy to copy",
                            .values = "a number above 0",
                            .typed = "NUMBER > 0",
                            .unit = "radii",
                            .initial = "as many whole copies as fit, end to end"},
                           &AlongSettings::spacing, read_radius),
          along_number_row({.key = "along_twist",
                            .help = "turn the meshes so often from the start of the stroke to its end",
                            .unit = "turns",
                            .initial = "0"},
                           &AlongSettings::twist, read_finite),
          along_number_row({.key = "along_height",
                            .help = "height of the meshes' lowest point over the surface",
                            .unit = "radii",
                            .initial = "0"},
                           &AlongSettings::height, read_finite)};
}

constexpr std::array named_axes{Named{"x", 0}, Named{"y", 1}, Named{"z", 2}};

std::vector<SettingRow> symmetry_rows() {
  const Symmetry none;
  return {symmetry_row({.key = "mirror",
                        .help = "draw the stroke mirrored along these axes too",
                        .values = "a text of `x`, `y` and `z`",
                        .typed = "AXES",
                        .initial = "none"},
                       read_mirrors),
          symmetry_row({.key = "radial",
                        .help = "draw the stroke so many times around an axis",
                        .values = fmt::format("1 to {}", most_copies),
                        .typed = fmt::format("1..{}", most_copies),
                        .initial = fmt::format("{}", none.radial),
                        .form = SettingForm::number},
                       [](const JsonValue& value, Symmetry& into) {
                         into.radial = static_cast<int>(value.whole(1, most_copies));
                       }),
          symmetry_row(
              named_row({.key = "radial_axis",
                         .help = "that axis",
                         .initial = std::string(name_of(named_axes, none.axis)),
                         .needs = "radial"},
                        named_axes),
              [](const JsonValue& value, Symmetry& into) { into.axis = read_choice(value, named_axes); }),
          symmetry_row({.key = "symmetry_centre",
                        .help = "where mirror planes and axis meet",
                        .values = "[x, y, z]",
                        .typed = "X,Y,Z",
                        .unit = "object units",
                        .initial = "the origin",
                        .form = SettingForm::numbers},
                       [](const JsonValue& value, Symmetry& into) { into.centre = read_point(value); })};
}

std::vector<SettingRow> sample_rows() {
  return {member_row({.key = "stabilise",
                      .help = "calm the samples: the brush hangs on a string of this length, in units of the "
                              "recording's space, or lags behind by these seconds",
                      .values = "`string:LENGTH` or `exponential:SECONDS`",
                      .typed = "KIND:AMOUNT",
                      .initial = "none"},
                     &S::stabilising, read_stabilising),
          member_row({.key = "show_every",
                      .help = "show every so many samples; 0: the whole stroke at its end",
                      .values = fmt::format("0 to {}", most_shown),
                      .typed = fmt::format("0..{}", most_shown),
                      .initial = fmt::format("{}", defaults.show_every),
                      .form = SettingForm::number},
                     &S::show_every, [](const JsonValue& value) {
                       return static_cast<std::size_t>(value.whole(0, most_shown));
                     })};
}

std::vector<SettingRow> all_rows() {
  std::vector<SettingRow> rows;
  for (auto some : {basic_rows, shape_rows, surface_rows, solid_rows, along_rows, symmetry_rows, sample_rows})
    std::ranges::move(some(), std::back_inserter(rows));
  for (SettingRow& row : rows) {
    if (!row.option.empty()) continue;
    row.option = "--" + row.key;
    std::ranges::replace(row.option, '_', '-');
  }
  return rows;
}

}  // namespace

std::span<const SettingRow> setting_table() {
  static const std::vector<SettingRow> rows = all_rows();
  return rows;
}

const SettingRow& setting_row(std::string_view key) {
  return *std::ranges::find(setting_table(), key, &SettingRow::key);
}

void read_settings(const JsonValue& object, SettingsOf what, GivenSettings& into) {
  for (const SettingRow& row : setting_table()) {
    if (what == SettingsOf::recording && !row.recorded) continue;
    const auto value = object.find(row.key);
    if (!value) continue;
    row.read(*value, into);
    if (!row.needs.empty() && !object.find(row.needs))
      value->reject(fmt::format("decides nothing without '{}'", row.needs));
  }
}

void write_settings(const GivenSettings& given, Json& into) {
  for (const SettingRow& row : setting_table())
    if (row.recorded) row.write(given, into);
  GivenSettings read;
  read_settings(JsonValue::of(nlohmann::json(into), "settings"), SettingsOf::recording, read);
}

}  // namespace burin
