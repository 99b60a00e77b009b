#pragma once

#include <array>
#include <string_view>

/// \file
/// The names by which fields are found where the user names none, and the texts that mean that
/// there is no reading. Case is ignored. The readers of files look here, and so does the manual.

namespace thiessen::known {

/// The id of a station; the first of these names that a table has is taken.
inline constexpr std::array<std::string_view, 11> station_ids = {
    "id",    "station", "station_id", "stnid", "staid", "site_no",
    "gauge", "gage",    "code",       "num",   "name"};

inline constexpr std::array<std::string_view, 5> eastings = {"lon", "long", "longitude", "x",
                                                             "easting"};
inline constexpr std::array<std::string_view, 4> northings = {"lat", "latitude", "y", "northing"};

/// Of eastings and northings those that say longitude and latitude on WGS 84.
inline constexpr std::array<std::string_view, 5> degrees = {"lon", "long", "longitude", "lat",
                                                            "latitude"};

/// The id of a basin; the first of these names whose values are all there and all different is
/// taken.
inline constexpr std::array<std::string_view, 5> basin_ids = {"basin", "basin_id", "id", "code",
                                                              "name"};

/// The time of a reading in a table of one reading a row.
inline constexpr std::array<std::string_view, 3> times = {"time", "date", "datetime"};

/// The value of a reading in such a table; a unit may follow (prcp_mm, rain (mm)).
inline constexpr std::array<std::string_view, 7> values = {
    "value", "rain", "rainfall", "precipitation", "prcp", "precip", "p"};

/// Texts that mean that there is no reading, beside an empty field. Numbers among them compare as
/// numbers.
inline constexpr std::array<std::string_view, 8> gaps = {"NA", "N/A",  "NaN",   "null",
                                                         "-",  "-999", "-9999", "-99.9"};

}  // namespace thiessen::known
