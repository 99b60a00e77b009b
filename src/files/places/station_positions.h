#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "base/error.h"
#include "earth/degrees_text.h"
#include "files/places/station_fields.h"
#include "files/places/stations_file.h"
#include "files/tables/features.h"
#include "rainfall/network/network.h"

namespace thiessen {

/// Whether a station's position could be read.
enum class Placing {
  good,
  bad,      ///< there is a complaint
  nowhere,  ///< it has no coordinates, and such stations are passed over
};

/// Reads the positions of stations, a feature at a time: from two columns, as numbers or in
/// degrees, minutes and seconds, or from a geometry that is a point.
///
/// A text that means that there is no reading (NA, null, -) means that there is no coordinate, and
/// so does such a number (-999, -9999, -99.9) where it can be no degree, and -999 or -9999 of both
/// coordinates of a plane.
class StationPositions {
 public:
  /// All four must outlive this object.
  StationPositions(Features& features, const StationFields& fields, const StationsRequest& request,
                   Complaints& complaints)
      : features_(features), fields_(fields), request_(request), complaints_(complaints) {}

  /// Reads the position of the feature last read into its station. What is wrong with it goes to
  /// the complaints.
  Placing read(Station& station);

  /// The first coordinate that was written in minutes, and what it was read as; empty where none
  /// was.
  const std::string& first_angle() const { return first_angle_; }
  bool has_heights() const { return heights_; }

 private:
  Placing read_columns(Station& station);
  Placing read_geometry(Station& station);
  bool read_plainly(Station& station) const;
  bool is_nowhere() const;
  bool is_missing(std::size_t field, double most_degrees) const;
  std::optional<double> read_number(const Station& station, std::size_t field,
                                    DegreesText::Axis axis);
  Wording hint_for_mark(std::string_view text) const;
  bool may_be_angle(const DegreesText& angle) const;
  std::optional<double> read_angle(const DegreesText& angle, std::string_view text,
                                   const std::string& what, DegreesText::Axis axis);
  Wording leave_out(bool is_unplaced = false) const;
  Placing complain(Wording text, Wording hint = {});

  Features& features_;
  const StationFields& fields_;
  const StationsRequest& request_;
  Complaints& complaints_;
  std::string first_angle_;
  bool heights_ = false;
};

}  // namespace thiessen
