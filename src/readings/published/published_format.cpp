#include "readings/published/published_format.h"

#include <algorithm>
#include <array>

#include "base/utf8.h"
#include "text/field_names.h"

namespace thiessen {
namespace {

// Each row is written from the publisher's own description; tests/formats/README.md names it.
constexpr std::array<PublishedFormat, 20> formats = {{
    {.name = "NOAA's Global Summary of the Day",
     .columns = "STATION, DATE, TEMP, DEWP, PRCP, FRSHTT",
     .station = "STATION",
     .time = "DATE",
     .value = "PRCP",
     .unit = "in",
     .missing = "99.99"},
    {.name = "NOAA's GHCN-Daily, a column an element",
     .columns = "STATION, DATE, LATITUDE, LONGITUDE, ELEVATION, NAME, PRCP, PRCP_ATTRIBUTES",
     .station = "STATION",
     .time = "DATE",
     .value = "PRCP",
     .unit = "0.1mm",
     .flags = "PRCP_ATTRIBUTES",
     .flag_place = 1,
     .whole_numbers = true},
    {.name = "NOAA's GHCN-Daily by year or by station",
     .columns = "ID, DATE, ELEMENT, DATA_VALUE|DATAVALUE|VALUE, M_FLAG|MFLAG|M, Q_FLAG|QFLAG|Q, "
                "S_FLAG|SFLAG|S",
     .station = "ID",
     .time = "DATE",
     .value = "DATA_VALUE|DATAVALUE|VALUE",
     .unit = "0.1mm",
     .kept = "ELEMENT=PRCP",
     .flags = "Q_FLAG|QFLAG|Q",
     .whole_numbers = true},
    {.name = "an order of NOAA's Climate Data Online, with flags",
     .columns = "STATION, NAME, DATE, PRCP, PRCP_ATTRIBUTES",
     .station = "STATION",
     .time = "DATE",
     .value = "PRCP",
     .flags = "PRCP_ATTRIBUTES",
     .flag_place = 1,
     .unit_is_ordered = true},
    {.name = "an order of NOAA's Climate Data Online",
     .columns = "STATION, NAME, DATE, PRCP",
     .station = "STATION",
     .time = "DATE",
     .value = "PRCP",
     .unit_is_ordered = true},
    {.name = "DWD's hourly precipitation",
     .columns = "STATIONS_ID, MESS_DATUM, QN_8, R1",
     .station = "STATIONS_ID",
     .time = "MESS_DATUM",
     .value = "R1",
     .unit = "mm",
     .missing = "-999",
     .ids_as_numbers = true},
    {.name = "DWD's daily precipitation",
     .columns = "STATIONS_ID, MESS_DATUM, QN_6, RS",
     .station = "STATIONS_ID",
     .time = "MESS_DATUM",
     .value = "RS",
     .unit = "mm",
     .missing = "-999",
     .ids_as_numbers = true},
    {.name = "DWD's daily climate",
     .columns = "STATIONS_ID, MESS_DATUM, QN_3, QN_4, RSK",
     .station = "STATIONS_ID",
     .time = "MESS_DATUM",
     .value = "RSK",
     .unit = "mm",
     .missing = "-999",
     .ids_as_numbers = true},
    {.name = "DWD's precipitation of ten minutes",
     .columns = "STATIONS_ID, MESS_DATUM, QN, RWS_10",
     .station = "STATIONS_ID",
     .time = "MESS_DATUM",
     .value = "RWS_10",
     .unit = "mm",
     .missing = "-999",
     .ids_as_numbers = true},
    {.name = "DWD's precipitation of a minute",
     .columns = "STATIONS_ID, MESS_DATUM|MESS_DATUM_BEGINN, QN, RS_01",
     .station = "STATIONS_ID",
     .time = "MESS_DATUM|MESS_DATUM_BEGINN",
     .value = "RS_01",
     .unit = "mm",
     .missing = "-999",
     .ids_as_numbers = true},
    {.name = "DWD's monthly precipitation",
     .columns = "STATIONS_ID, MESS_DATUM_BEGINN, MESS_DATUM_ENDE, QN_6, MO_RR",
     .station = "STATIONS_ID",
     .time = "MESS_DATUM_BEGINN",
     .value = "MO_RR",
     .unit = "mm",
     .missing = "-999",
     .ids_as_numbers = true},
    {.name = "KNMI's daily precipitation",
     .columns = "STN, YYYYMMDD, RD",
     .station = "STN",
     .time = "YYYYMMDD",
     .value = "RD",
     .unit = "0.1mm",
     .whole_numbers = true},
    {.name = "KNMI's hourly weather",
     .columns = "STN, YYYYMMDD, HH, RH",
     .station = "STN",
     .time = "YYYYMMDD, HH",
     .value = "RH",
     .unit = "0.1mm",
     .trace = "-1",
     .whole_numbers = true},
    {.name = "KNMI's daily weather",
     .columns = "STN, YYYYMMDD, RH",
     .station = "STN",
     .time = "YYYYMMDD",
     .value = "RH",
     .unit = "0.1mm",
     .trace = "-1",
     .whole_numbers = true},
    {.name = "M\u00e9t\u00e9o-France's daily data",
     .columns = "NUM_POSTE, NOM_USUEL, LAT, LON, ALTI, AAAAMMJJ, RR",
     .station = "NUM_POSTE",
     .time = "AAAAMMJJ",
     .value = "RR",
     .unit = "mm"},
    {.name = "M\u00e9t\u00e9o-France's hourly data",
     .columns = "NUM_POSTE, NOM_USUEL, LAT, LON, ALTI, AAAAMMJJHH, RR1",
     .station = "NUM_POSTE",
     .time = "AAAAMMJJHH",
     .value = "RR1",
     .unit = "mm"},
    {.name = "MeteoSwiss's precipitation",
     .columns = "station_abbr|station/location|stn, reference_timestamp|date|time, "
                "rre150d0|rka150d0|rre150h0|rre150z0",
     .station = "station_abbr|station/location|stn",
     .time = "reference_timestamp|date|time",
     .value = "rre150d0|rka150d0|rre150h0|rre150z0",
     .unit = "mm"},
    {.name = "Environment Canada's daily data",
     .columns = "Longitude_(x), Latitude_(y), Station_Name, Climate_ID, Date/Time, "
                "Total_Precip_(mm)",
     .station = "Climate_ID",
     .time = "Date/Time",
     .value = "Total_Precip_(mm)",
     .unit = "mm"},
    {.name = "the Bureau of Meteorology's daily rainfall",
     .columns = "Product_code, Bureau_of_Meteorology_station_number, Year, Month, Day, "
                "Rainfall_amount_(millimetres)",
     .station = "Bureau_of_Meteorology_station_number",
     .time = "Year, Month, Day",
     .value = "Rainfall_amount_(millimetres)",
     .unit = "mm",
     .period = "Period_over_which_rainfall_was_measured_(days)",
     .ids_as_numbers = true},
    {.name = "SILO's daily rainfall",
     .columns = "station, YYYY-MM-DD, daily_rain",
     .station = "station",
     .time = "YYYY-MM-DD",
     .value = "daily_rain",
     .unit = "mm",
     .ids_as_numbers = true},
}};

bool is_among(std::string_view name, std::string_view names) {
  for (const std::string_view one : parted(names, '|')) {
    if (same_name(name, one)) return true;
  }
  return false;
}

bool fits(const std::vector<std::string>& header, const PublishedFormat& format) {
  std::size_t at = 0;
  for (const std::string_view names : parted(format.columns, ',')) {
    while (at < header.size() && !is_among(header[at], names)) ++at;
    if (at++ == header.size()) return false;
  }
  return true;
}

/// Whether names are in capitals, as CDO writes them, for they are common names in small letters.
bool is_shouted(const std::vector<std::string>& header) {
  return std::ranges::all_of(header, [](const std::string& name) {
    return std::ranges::none_of(name, [](char c) { return c >= 'a' && c <= 'z'; });
  });
}

bool is_all_of(std::string_view text, std::string_view letters) {
  return text.find_first_not_of(letters) == std::string_view::npos;
}

}  // namespace

std::span<const PublishedFormat> published_formats() {
  return formats;
}

const PublishedFormat& ghcn_without_header() {
  static constexpr PublishedFormat format = {
      .name = "NOAA's GHCN-Daily by year or by station, without a header",
      .columns = "1, 2, 3, 4, 5, 6, 7, 8",
      .station = "1",
      .time = "2",
      .value = "4",
      .unit = "0.1mm",
      .kept = "3=PRCP",
      .flags = "6",
      .whole_numbers = true};
  return format;
}

bool is_ghcn_row(const std::vector<std::string>& fields) {
  constexpr std::string_view digits = "0123456789";
  constexpr std::string_view capitals = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  return fields.size() == 8 && fields[0].size() == 11 && is_all_of(fields[0], capitals) &&
         fields[1].size() == 8 && is_all_of(fields[1], digits) && fields[2].size() == 4 &&
         is_all_of(fields[2], capitals) && !fields[3].empty() &&
         is_all_of(fields[3], "-0123456789");
}

std::optional<std::size_t> published_column(const std::vector<std::string>& header,
                                            std::string_view names) {
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (is_among(header[i], names)) return i;
  }
  return std::nullopt;
}

std::vector<std::string_view> parted(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(separator);
    parts.push_back(trimmed(text.substr(0, end)));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

const PublishedFormat* format_of_header(const std::vector<std::string>& header) {
  for (const PublishedFormat& format : formats) {
    if (fits(header, format) && (!format.unit_is_ordered || is_shouted(header))) return &format;
  }
  return nullptr;
}

}  // namespace thiessen
