#pragma once

#include <array>
#include <cstddef>
#include <string_view>

/// \file
/// The names by which fields are found where the user names none, in the languages of agencies
/// (English, German, Spanish, French, Portuguese, Japanese), and the texts that mean that
/// there is no reading. Names are compared as same_name says. The readers of files look here, and
/// so does the manual.

namespace thiessen::known {

template <typename... Text>
constexpr std::array<std::string_view, sizeof...(Text)> names(const Text&... texts) {
  return {texts...};
}

/// The id of a station; the first of these names that a table has is taken. Words for it come
/// before words that may mean something else.
inline constexpr auto station_ids =
    names("id", "station", "station_id", "stnid", "staid", "site_no", "station_no", "station_nr",
          "station_number", "stations_id", "station_code", "stationid", "statid", "stid", "stn",
          "stn_id", "gauge_id", "gauge_no", "gage_id", "site", "site_id", "site_code",
          "site_number", "climate_id", "station_abbr", "wmo_id", "wmo", "estacion", "estación",
          "id_estacion", "codigo", "código", "codigo_estacion", "indicativo", "indicatif", "poste",
          "num_poste", "numer_sta", "code_station", "station_meteo", "posto", "estacao", "estação",
          "cod_estacao", "cd_estacao", "codigo_estacao", "stationsnummer", "stationsnr",
          "stationskennung", "messstelle", "messstellennummer", "messstation", "kennung",
          "観測所番号", "観測所", "地点番号", "地点", "gauge", "gage", "code", "num", "name");

/// A longitude or an easting.
inline constexpr auto eastings =
    names("lon", "long", "longitude", "x", "easting", "lng", "longitude_deg", "lon_deg", "longdeg",
          "long_dd", "lon_dd", "longdd", "londd", "decimallongitude", "decimal_longitude",
          "dec_long_va", "dec_lon", "station_longitude", "station_lon", "stn_lon", "stn_long",
          "site_longitude", "gauge_lon", "lon_wgs84", "longitude_wgs84", "longitude (x)",
          "station_coordinates_wgs84_lon", "longitud", "geolaenge", "geolänge", "geo_laenge",
          "geogr_laenge", "laenge", "länge", "laengengrad", "längengrad", "geographische_laenge",
          "longitudine", "経度", "東経", "x_coord", "xcoord", "coord_x", "coordx", "utm_x", "x_utm",
          "utme", "utm_e", "e_utm", "east", "este", "rechtswert", "ostwert", "x_wert", "x_lambert",
          "lambert_x", "x_l93", "coordonnee_x", "longitude_dd", "longitude_decimal", "long_dec",
          "lon_dec", "longitude_dec", "vl_longitude", "geogr_länge");

/// A latitude or a northing.
inline constexpr auto northings = names(
    "lat", "latitude", "y", "northing", "latitude_deg", "lat_deg", "latdeg", "lat_dd", "latdd",
    "decimallatitude", "decimal_latitude", "dec_lat_va", "dec_lat", "station_latitude",
    "station_lat", "stn_lat", "site_latitude", "gauge_lat", "lat_wgs84", "latitude_wgs84",
    "latitude (y)", "station_coordinates_wgs84_lat", "latitud", "geobreite", "geo_breite",
    "geogr_breite", "breite", "breitengrad", "geographische_breite", "latitudine", "緯度", "北緯",
    "y_coord", "ycoord", "coord_y", "coordy", "utm_y", "y_utm", "utmn", "utm_n", "n_utm", "north",
    "norte", "hochwert", "nordwert", "y_wert", "y_lambert", "lambert_y", "y_l93", "coordonnee_y",
    "latitude_dd", "latitude_decimal", "lat_dec", "latitude_dec", "vl_latitude");

/// The names of eastings and northings that say longitude and latitude on WGS 84.
inline constexpr auto degrees = names(
    "lon", "long", "longitude", "lng", "longitude_deg", "lon_deg", "longdeg", "long_dd", "lon_dd",
    "longdd", "londd", "decimallongitude", "decimal_longitude", "dec_long_va", "dec_lon",
    "station_longitude", "station_lon", "stn_lon", "stn_long", "site_longitude", "gauge_lon",
    "lon_wgs84", "longitude_wgs84", "longitude (x)", "station_coordinates_wgs84_lon", "longitud",
    "geolaenge", "geolänge", "geo_laenge", "geogr_laenge", "laenge", "länge", "laengengrad",
    "längengrad", "geographische_laenge", "longitudine", "経度", "東経", "lat", "latitude",
    "latitude_deg", "lat_deg", "latdeg", "lat_dd", "latdd", "decimallatitude", "decimal_latitude",
    "dec_lat_va", "dec_lat", "station_latitude", "station_lat", "stn_lat", "site_latitude",
    "gauge_lat", "lat_wgs84", "latitude_wgs84", "latitude (y)", "station_coordinates_wgs84_lat",
    "latitud", "geobreite", "geo_breite", "geogr_breite", "breite", "breitengrad",
    "geographische_breite", "latitudine", "緯度", "北緯", "longitude_dd", "longitude_decimal",
    "long_dec", "lon_dec", "longitude_dec", "vl_longitude", "geogr_länge", "latitude_dd",
    "latitude_decimal", "lat_dec", "latitude_dec", "vl_latitude");

/// How many of the names above a message lists: the English ones.
inline constexpr std::size_t eastings_told = 5;
inline constexpr std::size_t northings_told = 4;

/// The id of a basin; the first of these names whose values are all there and all different is
/// taken.
inline constexpr auto basin_ids = names("basin", "basin_id", "id", "code", "name");

/// The time of a reading in a table of one reading a row.
inline constexpr auto times =
    names("time", "date", "datetime", "date_time", "timestamp", "datum", "zeit", "zeitpunkt",
          "zeitstempel", "mess_datum", "messdatum", "messzeitpunkt", "fecha", "fecha_hora", "hora",
          "data", "data_hora", "dia", "horodate", "horodatage", "date_heure", "jour", "date_utc",
          "datetime_utc", "time_utc", "observation_time", "obs_time", "valid_time", "day", "日時",
          "日付", "年月日", "年月日時", "時刻");

/// The parts of a time that stands in several columns.
inline constexpr auto years =
    names("year", "yyyy", "yr", "jahr", "año", "annee", "ano", "année", "yy");
inline constexpr auto months = names("month", "mm", "mon", "monat", "mes", "mois", "mo", "mês");
inline constexpr auto days =
    names("day", "dd", "tag", "dia", "jour", "dy", "día", "dom", "mday", "day_of_month");
inline constexpr auto days_of_year = names("doy", "jday", "day_of_year", "dayofyear", "yday",
                                           "julian_day", "julianday", "julday", "jul_day");
inline constexpr auto hours = names("hour", "hh", "hr", "stunde", "hora", "heure");
/// An hour and its minute as one number: 30, 100, 2400.
inline constexpr auto hours_with_minutes = names("hhmm", "hrmn", "hrmin");
inline constexpr auto minutes = names("minute", "min", "minuto", "mi", "minuten");
inline constexpr auto seconds = names("second", "sec", "ss", "segundo", "sekunde", "seconde");
/// Parts of months, and of years, that make up no date by themselves.
inline constexpr auto parts_of_months =
    names("week", "wk", "woche", "semana", "semaine", "dekad", "decade", "pentad", "period");
inline constexpr auto parts_of_years =
    names("season", "quarter", "trimester", "trimestre", "saison", "quartal");

/// A date in one column whose clock stands in another. Either counts only where its values are
/// that.
inline constexpr auto dates =
    names("date", "datum", "fecha", "data", "dia", "jour", "day", "date_utc", "utc_date",
          "data_medicao", "dt_medicao", "日付", "年月日", "yyyymmdd");
inline constexpr auto clocks =
    names("time", "hour", "hora", "uhrzeit", "zeit", "heure", "clock", "hh", "hr", "stunde",
          "time_utc", "utc_time", "hour_utc", "hora_utc", "hora (utc)", "time (utc)",
          "hora_medicao", "hr_medicao", "ora", "時刻", "時", "hhmm");

/// The value of a reading in such a table; a unit may follow (prcp_mm, rain (mm)).
inline constexpr auto values = names(
    "value", "rain", "rainfall", "precipitation", "prcp", "precip", "p", "rainfall_amount",
    "rain_amount", "precip_amount", "precipitation_amount", "daily_rainfall", "daily_precipitation",
    "tp", "pcp", "ppt", "rr", "rs", "rrr", "niederschlag", "niederschlagshoehe",
    "niederschlagshöhe", "regen", "wert", "messwert", "nied", "nsh", "rsk", "precipitacion",
    "precipitación", "lluvia", "valor", "prec", "pluie", "pluviometrie", "pluviométrie",
    "precipitations", "précipitations", "précipitation", "hauteur", "valeur", "chuva",
    "precipitacao", "precipitação", "降水量", "雨量", "降雨量", "値", "prectotcorr");

/// The column of a table of one reading a row that says what each is in.
inline constexpr auto unit_columns =
    names("unit", "units", "uom", "unit_of_measure", "unit_of_measurement", "measure_unit",
          "measurement_unit", "value_unit", "value_units", "unit_code", "unit_cd", "unit_symbol",
          "einheit", "unidad", "unidade", "unité", "unite", "unità", "単位");

/// Names of the column of values that do not say of what.
inline constexpr auto bare_values =
    names("value", "data_value", "valor", "wert", "messwert", "valeur", "値");

/// The column of days that an amount was gathered in.
inline constexpr auto gathered_days = names("days", "n_days", "ndays", "num_days", "number_of_days",
                                            "period_days", "days_gathered", "tage", "dias");

/// The column of a table of one reading a row that says what was measured.
inline constexpr auto measured =
    names("parameter", "element", "variable", "datatype", "data_type", "param", "measurand",
          "variavel", "parametro", "quantity", "obs_type", "parameter_name");

/// What a line above a header calls the unit of what is below it.
inline constexpr auto unit_labels =
    names("unit", "units", "unit of measure", "unit of measurement", "measurement unit",
          "data units", "rain unit", "rainfall unit", "rainfall units", "precipitation unit",
          "precipitation units", "einheit", "unidad", "unidade", "unité");

/// Texts that mean that there is no reading, beside an empty field. Numbers among them compare as
/// numbers.
inline constexpr auto gaps = names("NA", "N/A", "NaN", "null", "-", "-999", "-9999", "-99.9");

/// A geometry in WKT.
inline constexpr auto geometries = names("wkt", "wkt_geom", "geometry", "geom", "the_geom");

/// What stands in a row of units below the header, alone or in brackets.
inline constexpr auto units = names(
    "mm", "cm", "m", "in", "inch", "inches", "ft", "feet", "mm/h", "mm/hr", "mm/d", "mm/day",
    "in/h", "in/hr", "l/m2", "l/m²", "l/qm", "kg/m2", "kg/m²", "kg m-2", "°C", "degC", "deg C", "C",
    "°F", "K", "%", "hPa", "m/s", "m s-1", "°", "deg", "degrees", "degree", "0.1mm", "0.1 mm",
    "1/10 mm", "mm h-1", "mm hr-1", "mm d-1", "mm day-1", "mm s-1", "mm/s", "mm/min", "in/d",
    "in/day", "mm per h", "mm/month", "mm/hour", "in/hour", "mm/15min", "mm/10min", "kg m-2 s-1");

/// A column at the end of a table that holds nothing but its own name, or a mark of the end.
inline constexpr std::string_view end_of_record = "eor";

/// The elevation of a station or a basin.
inline constexpr auto elevations = names("elev", "elevation", "z", "alt", "altitude");

}  // namespace thiessen::known
