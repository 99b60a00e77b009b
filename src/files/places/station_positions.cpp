#include "files/places/station_positions.h"

#include <utility>

#include "base/number.h"
#include "base/utf8.h"
#include "geometry/shape_points.h"
#include "text/csv_records.h"

namespace thiessen {

Placing StationPositions::read(Station& station) {
  return fields_.by_geometry ? read_geometry(station) : read_columns(station);
}

Placing StationPositions::read_columns(Station& station) {
  using Axis = DegreesText::Axis;
  const auto& fields = features_.row().fields;
  const bool is_nowhere = trimmed(fields[fields_.x]).empty() && trimmed(fields[fields_.y]).empty();
  if (is_nowhere && request_.skip_unplaced) return Placing::nowhere;
  if (is_nowhere)
    return complain("station " + quoted(station.id, 80) + " has no coordinates", leave_out(true));
  const auto x = read_number(station, fields_.x, Axis::longitude);
  const auto y = read_number(station, fields_.y, Axis::latitude);
  // Adding zero turns -0 into 0, so that both are the same place.
  if (x && y) station.position = {*x + 0.0, *y + 0.0};
  return x && y ? Placing::good : Placing::bad;
}

std::optional<double> StationPositions::read_number(const Station& station, std::size_t field,
                                                    DegreesText::Axis axis) {
  const std::string_view text = trimmed(features_.row().fields[field]);
  const auto number = parse_number(text, features_.decimal_mark());
  if (number) return number.value;
  const std::string what =
      quoted(features_.header()[field], 40) + " of station " + quoted(station.id, 80);
  if (text.empty()) {
    complain(what + " is empty",
             setting("skip_unplaced") + " passes over stations without coordinates");
  } else if (number.fault == NumberFault::out_of_range) {
    complain(what + " is outside the range of numbers: " + quoted(text, 60));
  } else if (const auto angle = degrees_text(text); angle && may_be_angle(*angle)) {
    return read_angle(*angle, text, what, axis);
  } else {
    complain(what + no_number_for_its_comma(text) + ": " + quoted(text, 60), hint_for_mark(text));
  }
  return std::nullopt;
}

/// What may be done where a text would be a number by the other decimal mark.
Wording StationPositions::hint_for_mark(std::string_view text) const {
  if (parse_number(text)) return hint_for_its_point("stations", request_.source.csv.decimal_comma);
  return parse_number(text, DecimalMark::comma) ? hint_for_its_comma(text, "stations") : Wording();
}

/// 12:30 in a column that nothing calls degrees may be anything.
bool StationPositions::may_be_angle(const DegreesText& angle) const {
  return fields_.are_degrees || angle.axis != DegreesText::Axis::unsaid;
}

std::optional<double> StationPositions::read_angle(const DegreesText& angle, std::string_view text,
                                                   const std::string& what,
                                                   DegreesText::Axis axis) {
  if (angle.axis != DegreesText::Axis::unsaid && angle.axis != axis) {
    const bool is_latitude = angle.axis == DegreesText::Axis::latitude;
    complain(what + " is a " + (is_latitude ? "latitude" : "longitude") + ": " + quoted(text, 60),
             setting("x") + " and " + setting("y") + " name the fields");
    return std::nullopt;
  }
  if (first_angle_.empty())
    first_angle_ = quoted(text, 60) + " for " + shortest_text(angle.degrees);
  return angle.degrees;
}

Placing StationPositions::read_geometry(Station& station) {
  try {
    const GeometryRecord geometry = features_.geometry();
    const std::string what = "station " + quoted(station.id, 80);
    const bool is_nowhere =
        geometry.type.empty() || (geometry.type == "Point" && geometry.points.empty());
    if (is_nowhere && request_.skip_unplaced) return Placing::nowhere;
    if (geometry.type.empty()) return complain(what + " has no geometry", leave_out(true));
    if (geometry.type != "Point" && geometry.type != "MultiPoint") {
      return complain(what + " is a " + geometry.type + ", and not a point",
                      geometry.polygons.empty() ? leave_out()
                                                : "are " + input("stations") + " and " +
                                                      input("basins") + " in each other's place?");
    }
    if (geometry.points.empty())
      return complain(what + " has an empty geometry", leave_out(geometry.type == "Point"));
    if (geometry.points.size() > 1) return complain(what + " has more than one point", leave_out());
    const Point at = geometry.points[0];
    if (!is_finite(at)) {
      return complain(what + " has a coordinate that is not finite", leave_out());
    }
    heights_ = heights_ || geometry.has_z;
    station.position = {at.x + 0.0, at.y + 0.0};
    return Placing::good;
  } catch (const Error& error) {
    for (const Message& message : error.messages()) complaints_.add(message);
    return Placing::bad;
  }
}

/// What may be done about a station that has no good geometry, or none at all.
Wording StationPositions::leave_out(bool is_unplaced) const {
  if (is_unplaced) return setting("skip_unplaced") + " passes over stations without coordinates";
  return setting(request_.source.where_setting) + " leaves stations out";
}

Placing StationPositions::complain(Wording text, Wording hint) {
  complaints_.add(features_.message(std::move(text), std::move(hint)));
  return Placing::bad;
}

}  // namespace thiessen
