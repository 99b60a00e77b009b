#include "files/places/station_positions.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/number.h"
#include "base/utf8.h"
#include "geometry/shape_points.h"
#include "text/csv_records.h"
#include "text/known_names.h"

namespace thiessen {
namespace {

constexpr double most_longitude = 360;
constexpr double most_latitude = 90;

/// Whether a text is one of those that mean that there is no reading, and no number.
bool means_none(std::string_view text) {
  if (parse_number(text)) return false;
  return text.empty() || std::ranges::any_of(known::gaps, [&](std::string_view gap) {
           return !parse_number(gap) && equal_ignoring_case(gap, text);
         });
}

/// Whether a number is one of those that mean that there is no reading.
bool means_none(double number) {
  return std::ranges::any_of(known::gaps, [&](std::string_view gap) {
    const auto known = parse_number(gap);
    return known && known.value == number;
  });
}

/// Whether two coordinates that are the same number mean none. In a plane a gauge may stand at
/// almost any of them, but none at -999 and -999; -99.9 there may be kilometres.
bool mean_none(double x, double y, bool are_degrees) {
  constexpr double farthest_of_a_small_plane = -100;
  return x == y && means_none(x) && (are_degrees || x < farthest_of_a_small_plane);
}

std::string and_none(std::string_view x, std::string_view y) {
  if (x.empty() && y.empty()) return {};
  return ": " + quoted(x, 60) + " and " + quoted(y, 60) + " mean none";
}

}  // namespace

Placing StationPositions::read(Station& station) {
  return fields_.by_geometry ? read_geometry(station) : read_columns(station);
}

Placing StationPositions::read_columns(Station& station) {
  using Axis = DegreesText::Axis;
  const auto& fields = features_.row().fields;
  if (read_plainly(station)) return Placing::good;
  if (is_nowhere()) {
    if (request_.skip_unplaced) return Placing::nowhere;
    return complain("station " + quoted(station.id, 80) + " has no coordinates" +
                        and_none(trimmed(fields[fields_.x]), trimmed(fields[fields_.y])),
                    leave_out(true));
  }
  const auto x = read_number(station, fields_.x, Axis::longitude);
  const auto y = read_number(station, fields_.y, Axis::latitude);
  // Adding zero turns -0 into 0, so that both are the same place.
  if (x && y) station.position = {*x + 0.0, *y + 0.0};
  return x && y ? Placing::good : Placing::bad;
}

/// Reads two numbers that can be nothing but coordinates, as most are. Of numbers only those below
/// the least degrees, and two that are alike, may mean that there is none.
bool StationPositions::read_plainly(Station& station) const {
  const auto& fields = features_.row().fields;
  const auto x = parse_number(trimmed(fields[fields_.x]), features_.decimal_mark());
  const auto y = parse_number(trimmed(fields[fields_.y]), features_.decimal_mark());
  if (!x || !y || x.value == y.value) return false;
  if (fields_.are_degrees && (x.value < -most_longitude || y.value < -most_latitude)) return false;
  station.position = {x.value + 0.0, y.value + 0.0};
  return true;
}

/// Whether neither column of the feature has a coordinate.
bool StationPositions::is_nowhere() const {
  const auto& fields = features_.row().fields;
  if (is_missing(fields_.x, most_longitude) && is_missing(fields_.y, most_latitude)) return true;
  const auto x = parse_number(trimmed(fields[fields_.x]), features_.decimal_mark());
  const auto y = parse_number(trimmed(fields[fields_.y]), features_.decimal_mark());
  return x && y && mean_none(x.value, y.value, fields_.are_degrees);
}

/// Whether a column has no coordinate: a number that means none counts where it cannot be a
/// coordinate, as -999 of degrees.
bool StationPositions::is_missing(std::size_t field, double most_degrees) const {
  const std::string_view text = trimmed(features_.row().fields[field]);
  if (means_none(text)) return true;
  const auto number = parse_number(text, features_.decimal_mark());
  return number && fields_.are_degrees && number.value < -most_degrees && means_none(number.value);
}

std::optional<double> StationPositions::read_number(const Station& station, std::size_t field,
                                                    DegreesText::Axis axis) {
  const std::string_view text = trimmed(features_.row().fields[field]);
  const auto number = parse_number(text, features_.decimal_mark());
  const bool missing =
      is_missing(field, axis == DegreesText::Axis::latitude ? most_latitude : most_longitude);
  if (number && !missing) return number.value;
  const std::string what =
      quoted(features_.header()[field], 40) + " of station " + quoted(station.id, 80);
  if (missing) {
    complain(what + (text.empty() ? " is empty" : " is missing: " + quoted(text, 60)), leave_out());
    return std::nullopt;
  }
  if (number.fault == NumberFault::out_of_range) {
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
    if (mean_none(at.x, at.y, false) || (std::isnan(at.x) && std::isnan(at.y))) {
      if (request_.skip_unplaced) return Placing::nowhere;
      return complain(
          what + " has no coordinates" + and_none(shortest_text(at.x), shortest_text(at.y)),
          leave_out(true));
    }
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
