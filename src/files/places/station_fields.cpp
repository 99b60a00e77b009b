#include "files/places/station_fields.h"

#include <algorithm>
#include <span>
#include <string>
#include <string_view>

#include "text/field_names.h"
#include "text/known_names.h"

namespace thiessen {
namespace {

using Names = std::span<const std::string_view>;

bool is_among(const std::string& name, Names names) {
  return std::any_of(names.begin(), names.end(),
                     [&](std::string_view known) { return same_name(name, known); });
}

std::size_t named_field(const Features& features, const std::string& name,
                        const char* its_setting) {
  return require_field(features.header(), name, setting(its_setting), features.file(),
                       features.header_line());
}

/// The field whose name is `named`, else the first that has one of the usual names.
std::optional<std::size_t> coordinate_field(const Features& features, const std::string& named,
                                            const char* its_setting, Names names) {
  if (named.empty()) return find_field(features.header(), names);
  return named_field(features, named, its_setting);
}

[[noreturn]] void fail_without_coordinates(const Features& features, bool x, bool y) {
  std::string wanted;
  if (!x) wanted = listed(std::span(known::eastings).first(known::eastings_told));
  if (!y)
    wanted +=
        (x ? "" : ", and ") + listed(std::span(known::northings).first(known::northings_told));
  throw Error(
      Message{features.file(), features.header_line(),
              "no field of coordinates: wanted " + wanted + "; found " + listed(features.header()),
              x   ? "name it with " + setting("y")
              : y ? "name it with " + setting("x")
                  : "name them with " + setting("x") + " and " + setting("y")});
}

std::optional<std::size_t> id_field(const Features& features, const StationsRequest& request,
                                    const StationFields& fields) {
  const auto& header = features.header();
  if (!request.id.empty()) return named_field(features, request.id, "id");
  if (const auto known = find_field(header, known::station_ids)) return known;
  for (std::size_t i = 0; i < header.size(); ++i) {
    const bool is_position =
        features.is_geometry(i) || (!fields.by_geometry && (i == fields.x || i == fields.y));
    if (!is_position && !is_among(header[i], known::values)) return i;
  }
  return std::nullopt;
}

}  // namespace

StationFields find_station_fields(const Features& features, const StationsRequest& request) {
  const auto& header = features.header();
  StationFields fields;
  if (!request.label.empty()) fields.label = named_field(features, request.label, "label");
  const auto x = coordinate_field(features, request.x, "x", known::eastings);
  const auto y = coordinate_field(features, request.y, "y", known::northings);
  fields.by_geometry = features.has_geometry() && request.x.empty() && request.y.empty() &&
                       !(x && y && features.may_not_be_geometries());
  if (!fields.by_geometry) {
    if (!x || !y) fail_without_coordinates(features, x.has_value(), y.has_value());
    fields.x = *x;
    fields.y = *y;
    fields.are_degrees =
        is_among(header[*x], known::degrees) && is_among(header[*y], known::degrees);
  }
  fields.id = id_field(features, request, fields);
  return fields;
}

}  // namespace thiessen
