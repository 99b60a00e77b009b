#include "readings/published/published_formats.h"

#include <algorithm>
#include <array>

#include "base/utf8.h"
#include "text/field_names.h"

namespace thiessen {
namespace {

/// What KeyHourly.txt and KeyDaily.txt of Met Éireann say of the indicators of rain. A trace stands
/// as 0 in its files, and what stands there of a sum is the sum.
constexpr std::string_view met_eireann_key =
    "1=deposition|2=a trace or a sum|3=a trace or a sum of deposition|4=estimated|"
    "5=estimated deposition|6=an estimated trace";

// Each row is written from the publisher's own description; tests/formats/README.md names it.
constexpr std::array<PublishedFormat, 31> formats = {{
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
     .ordered_units = "mm 0.1mm in",
     .unit_is_ordered = true},
    {.name = "an order of NOAA's Climate Data Online",
     .columns = "STATION, NAME, DATE, PRCP",
     .station = "STATION",
     .time = "DATE",
     .value = "PRCP",
     .ordered_units = "mm 0.1mm in",
     .unit_is_ordered = true},
    {.name = "an order of NOAA's daily summaries",
     .columns = "STATION, DATE, PRCP",
     .station = "STATION",
     .time = "DATE",
     .value = "PRCP",
     .ordered_units = "mm 0.1mm in",
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
    {.name = "DWD's precipitation of five minutes",
     .columns = "STATIONS_ID, MESS_DATUM, QN_5min|QN, RS_05",
     .station = "STATIONS_ID",
     .time = "MESS_DATUM",
     .value = "RS_05",
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
    {.name = "DWD's yearly precipitation",
     .columns = "STATIONS_ID, MESS_DATUM_BEGINN, MESS_DATUM_ENDE, QN_6, JA_RR",
     .station = "STATIONS_ID",
     .time = "MESS_DATUM_BEGINN",
     .value = "JA_RR",
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
     .unit = "mm",
     .day_first = true},
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
    {.name = "Meteostat's hourly data",
     .columns = "year, month, day, hour, temp, temp_source, prcp, prcp_source",
     .station = "",
     .time = "year, month, day, hour",
     .value = "prcp",
     .unit = "mm",
     .source = "prcp_source",
     .models = "mosmix forecast model"},
    {.name = "Meteostat's daily data",
     .columns = "year, month, day, temp, temp_source, prcp, prcp_source",
     .station = "",
     .time = "year, month, day",
     .value = "prcp",
     .unit = "mm",
     .source = "prcp_source",
     .models = "mosmix forecast model"},
    {.name = "Meteostat's monthly data",
     .columns = "year, month, temp, temp_source, prcp, prcp_source",
     .station = "",
     .time = "year, month",
     .value = "prcp",
     .unit = "mm",
     .source = "prcp_source",
     .models = "mosmix forecast model"},
    {.name = "Met \u00c9ireann's hourly or daily data",
     .columns = "date, rain",
     .station = "",
     .time = "date",
     .value = "rain",
     .unit = "mm",
     .marks = "ind",
     .key = met_eireann_key,
     .trace_marks = "6",
     .begins = "Station Name:",
     .label = "Station Name:",
     .prefixes = "dly|hly",
     .repeated = "ind"},
    {.name = "Met \u00c9ireann's monthly data",
     .columns = "year, month, rain",
     .station = "",
     .time = "year, month",
     .value = "rain",
     .unit = "mm",
     .marks = "ind",
     .key = met_eireann_key,
     .trace_marks = "6",
     .begins = "Station Name:",
     .label = "Station Name:",
     .prefixes = "mly",
     .repeated = "ind"},
    {.name = "INMET's hourly data",
     .columns = "Data|DATA (YYYY-MM-DD), Hora UTC|HORA (UTC), PRECIPITA\u00c7\u00c3O TOTAL*",
     .station = "",
     .time = "Data|DATA (YYYY-MM-DD), Hora UTC|HORA (UTC)",
     .value = "PRECIPITA\u00c7\u00c3O TOTAL*",
     .unit = "mm",
     .missing = "-9999",
     .begins = "REGIAO:|REGI\u00c3O:",
     .label = "CODIGO (WMO):",
     .encoding = "Latin-1"},
    {.name = "CAMELS's forcing of a basin",
     .columns = "Year Mnth Day Hr, Dayl(s), PRCP(mm/day)",
     .station = "",
     .time = "Year Mnth Day Hr",
     .value = "PRCP(mm/day)",
     .unit = "mm/day",
     .is_of_basins = true},
    {.name = "CAMELS-GB's series of a basin",
     .columns = "date, precipitation, pet, temperature, discharge_spec, discharge_vol",
     .station = "",
     .time = "date",
     .value = "precipitation",
     .unit = "mm",
     .is_of_basins = true},
}};

/// Whether a header has columns of these names, in this order.
bool has_columns(const std::vector<std::string>& header,
                 std::span<const std::string_view> columns) {
  std::size_t at = 0;
  for (const std::string_view names : columns) {
    while (at < header.size() && !has_published_name(header[at], names)) ++at;
    if (at++ == header.size()) return false;
  }
  return true;
}

bool fits(const std::vector<std::string>& header, const PublishedFormat& format) {
  return has_columns(header, parted(format.columns, ','));
}

/// The columns of a format but for those of its rain.
std::vector<std::string_view> columns_without_rain(const PublishedFormat& format) {
  std::vector<std::string_view> columns = parted(format.columns, ',');
  std::erase_if(columns, [&](std::string_view names) {
    return names == format.value || names == format.flags || names == format.source;
  });
  return columns;
}

/// A publisher's table of weather other than rain.
struct OtherTable {
  std::string_view name;
  std::string_view columns;
};
constexpr std::array<OtherTable, 1> other_tables = {{
    {"a product of DWD's other than rain",
     "STATIONS_ID, MESS_DATUM, QN*, TT_TU|PP_10|TT_10|FF_10|FX_10|SD_SO|DS_10|V_N|TT|F|P|V_TE002"},
}};

/// Whether a column's name tells of rain, though no format has it.
bool tells_of_rain(const std::string& name) {
  constexpr std::array<std::string_view, 8> words = {"rain",  "precip", "prcp", "pcp",
                                                     "pluie", "chuva",  "rr",   "rs_"};
  const std::string plain = plain_name(name);
  return std::ranges::any_of(
      words, [&](std::string_view word) { return plain.find(word) != std::string::npos; });
}

/// Whether a header is that of a format but for the columns of its rain, which have names that are
/// no one else's. DWD's have a name for each step, so that another one may be of rain too.
bool fits_without_rain(const std::vector<std::string>& header, const PublishedFormat& format) {
  constexpr std::size_t telling = 3;  // columns, of which fewer may be anybody's
  const std::vector<std::string_view> columns = columns_without_rain(format);
  if (columns.front() == "STATIONS_ID") return false;
  return (columns.size() >= telling || !format.begins.empty()) && has_columns(header, columns);
}

bool begins_as(std::string_view beginning, const PublishedFormat& format) {
  if (beginning.starts_with(byte_order_mark)) beginning.remove_prefix(byte_order_mark.size());
  return std::ranges::any_of(parted(format.begins, '|'), [&](std::string_view text) {
    return equal_ignoring_case(beginning.substr(0, text.size()), text);
  });
}

/// Whether names are in capitals, as CDO writes them, for they are common names in small letters.
bool is_shouted(const std::vector<std::string>& header) {
  return std::ranges::all_of(header, [](const std::string& name) {
    return std::ranges::none_of(name, [](char c) { return c >= 'a' && c <= 'z'; });
  });
}

}  // namespace

std::span<const PublishedFormat> published_formats() {
  return formats;
}

bool begins_as_published(std::string_view beginning) {
  return std::ranges::any_of(formats, [&](const PublishedFormat& format) {
    return !format.begins.empty() && begins_as(beginning, format);
  });
}

std::string_view format_without_rain(const std::vector<std::string>& header,
                                     std::string_view beginning) {
  if (std::ranges::any_of(header, tells_of_rain)) return {};
  for (const PublishedFormat& format : formats) {
    if (begins_as(beginning, format) && fits_without_rain(header, format) &&
        (!format.unit_is_ordered || is_shouted(header)))
      return format.name;
  }
  for (const OtherTable& table : other_tables)
    if (has_columns(header, parted(table.columns, ','))) return table.name;
  return {};
}

const PublishedFormat* format_of_header(const std::vector<std::string>& header,
                                        std::string_view beginning) {
  constexpr std::size_t most_columns = 1000;  // far more than any of them has
  if (header.size() > most_columns) return nullptr;
  for (const PublishedFormat& format : formats) {
    if (begins_as(beginning, format) && fits(header, format) &&
        (!format.unit_is_ordered || is_shouted(header)))
      return &format;
  }
  return nullptr;
}

}  // namespace thiessen
