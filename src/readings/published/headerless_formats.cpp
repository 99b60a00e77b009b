#include "readings/published/headerless_formats.h"

#include <algorithm>
#include <array>
#include <vector>

#include "base/number.h"
#include "base/utf8.h"
#include "text/text_lines.h"

namespace thiessen {
namespace {

using Fields = std::vector<std::string_view>;

constexpr std::array<PublishedFormat, 3> formats = {{
    {.name = "NOAA's GHCN-Daily by year or by station, without a header",
     .columns = "ID, DATE, ELEMENT, DATA_VALUE, M_FLAG, Q_FLAG, S_FLAG, OBS_TIME",
     .station = "ID",
     .time = "DATE",
     .value = "DATA_VALUE",
     .unit = "0.1mm",
     .kept = "ELEMENT=PRCP",
     .flags = "Q_FLAG",
     .whole_numbers = true},
    {.name = "Meteostat's daily data, without a header",
     .columns = "date, tavg, tmin, tmax, prcp, snow, wdir, wspd, wpgt, pres, tsun",
     .station = "",
     .time = "date",
     .value = "prcp",
     .unit = "mm"},
    {.name = "Meteostat's hourly data, without a header",
     .columns = "date, hour, temp, dwpt, rhum, prcp, snow, wdir, wspd, wpgt, pres, tsun, coco",
     .station = "",
     .time = "date, hour",
     .value = "prcp",
     .unit = "mm"},
}};

bool is_all_of(std::string_view text, std::string_view letters) {
  return text.find_first_not_of(letters) == std::string_view::npos;
}

bool is_row_of_ghcn(const Fields& fields) {
  constexpr std::string_view digits = "0123456789";
  constexpr std::string_view capitals = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  return fields[0].size() == 11 && is_all_of(fields[0], capitals) && fields[1].size() == 8 &&
         is_all_of(fields[1], digits) && fields[2].size() == 4 && is_all_of(fields[2], capitals) &&
         !fields[3].empty() && is_all_of(fields[3], "-0123456789");
}

/// Whether a date is followed by numbers and empty fields alone.
bool is_row_of_meteostat(const Fields& fields) {
  const std::string_view date = fields[0];
  if (date.size() != 10 || date[4] != '-' || date[7] != '-' || !is_all_of(date, "-0123456789"))
    return false;
  return std::all_of(fields.begin() + 1, fields.end(),
                     [](std::string_view field) { return field.empty() || parse_number(field); });
}

bool is_hourly_row_of_meteostat(const Fields& fields) {
  constexpr double hours = 24;
  const auto hour = parse_number(fields[1]);
  return fields[1].size() <= 2 && hour && hour.value >= 0 && hour.value < hours &&
         is_row_of_meteostat(fields);
}

/// How a row of each of the formats is known that has as many fields.
constexpr std::array<bool (*)(const Fields&), formats.size()> is_row = {
    is_row_of_ghcn, is_row_of_meteostat, is_hourly_row_of_meteostat};

}  // namespace

std::span<const PublishedFormat> headerless_formats() {
  return formats;
}

const PublishedFormat* format_of_rows(std::string_view beginning) {
  if (beginning.starts_with(byte_order_mark)) beginning.remove_prefix(byte_order_mark.size());
  const Fields fields = parted(take_line(beginning), ',');
  for (std::size_t i = 0; i < formats.size(); ++i) {
    if (fields.size() == parted(formats[i].columns, ',').size() && is_row[i](fields))
      return &formats[i];
  }
  return nullptr;
}

}  // namespace thiessen
