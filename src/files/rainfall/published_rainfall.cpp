#include "files/rainfall/published_rainfall.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "files/rainfall/archived_rainfall.h"
#include "files/tables/csv_file.h"
#include "files/tables/filtered_table.h"
#include "files/tables/netcdf_rainfall.h"
#include "files/tables/netcdf_stations.h"
#include "files/tables/netcdf_unit.h"
#include "files/tables/packed_file.h"
#include "files/tables/table_file.h"
#include "readings/published/arcswat_files.h"
#include "readings/published/headerless_formats.h"
#include "readings/published/hourly_order.h"
#include "readings/published/month_rows.h"
#include "readings/published/published_format.h"
#include "readings/published/published_formats.h"
#include "readings/published/published_table.h"
#include "readings/published/swat_files.h"
#include "readings/published/text_beginning.h"
#include "readings/published/usgs_rdb.h"
#include "readings/readings_layout.h"
#include "readings/units/converted_readings.h"
#include "readings/units/rain_unit.h"
#include "text/csv_form.h"
#include "text/csv_reader.h"
#include "text/field_names.h"
#include "text/known_names.h"
#include "text/last_line.h"

namespace thiessen {
namespace {

/// A table, and its format where it is a published one.
struct Recognised {
  std::unique_ptr<Table> table;
  const PublishedFormat* format = nullptr;
  bool tells_encoding = false;
  std::vector<std::string> stations_told = {};
};

Recognised open_usgs(const std::string& file, const std::string& wanted, Warnings& warnings) {
  if (!has_usgs_rain(open_text(file))) {
    throw NoRain({file, 0,
                  "it is " + std::string(usgs_rdb_format().name) +
                      " without a column of precipitation (00045)",
                  ""});
  }
  auto table = std::make_unique<UsgsRdb>(
      file, [file] { return open_text(file); }, wanted, warnings);
  return {std::move(table), &usgs_rdb_format()};
}

Recognised open_arcswat(const std::string& file, ArcSwatFile kind) {
  const bool is_list = kind == ArcSwatFile::list;
  return {std::make_unique<ArcSwatRainfall>(file, kind, open_text),
          is_list ? &arcswat_list_format() : &arcswat_gauge_format()};
}

Recognised open_without_header(const std::string& file, const PublishedFormat& format,
                               CsvDialect said, Warnings& warnings) {
  said.separator = ',';
  for (const std::string_view name : parted(format.columns, ',')) said.names.emplace_back(name);
  return {open_csv(file, said, {}, warnings), &format};
}

/// A text of a published format that is no table with a header; no table where it is none.
Recognised open_text_format(const Source& rainfall, const std::string& beginning,
                            Warnings& warnings) {
  if (!rainfall.layer.empty()) return {};
  const std::string& file = rainfall.file;
  if (is_usgs_rdb(beginning)) return open_usgs(file, {}, warnings);
  if (const SwatFile kind = swat_file(beginning); kind != SwatFile::none)
    return {std::make_unique<SwatRainfall>(file, kind, open_text), &swat_format()};
  if (const ArcSwatFile kind = arcswat_file(beginning); kind != ArcSwatFile::none)
    return open_arcswat(file, kind);
  if (const PublishedFormat* format = format_of_rows(beginning))
    return open_without_header(file, *format, rainfall.csv, warnings);
  return {};
}

/// ANA's table, which is read twice: where it is packed, by a second reader.
Recognised open_months(std::unique_ptr<Table> table, const Source& source,
                       const std::string& beginning) {
  std::unique_ptr<Table> same = table->again();
  Warnings told_before;
  if (!same && !beginning.empty()) same = open_table(source, told_before);
  return {std::make_unique<MonthRows>(std::move(table), std::move(same)), &ana_format()};
}

/// The same of a table with a header.
Recognised open_table_format(const Source& rainfall, const std::string& beginning,
                             Warnings& warnings) {
  const TextBeginning told = look_at_beginning(beginning, rainfall.csv);
  Source source = rainfall;
  source.csv = told.dialect;
  auto table = open_table(source, warnings);
  if (is_ana_header(table->header())) return open_months(std::move(table), source, beginning);
  if (is_hourly_order_header(table->header()))
    return {std::make_unique<HourlyOrder>(std::move(table)), &hourly_order_format()};
  const PublishedFormat* format = format_of_header(table->header(), told.text);
  if (format == nullptr) return {std::move(table)};
  return {std::move(table), format, told.tells_encoding,
          stations_told(*format, told.text, rainfall.file)};
}

/// The same where the user names the column of values: a text without a header that names it, or
/// USGS's, whose sensors have a column each. No table where that column is of no such format.
Recognised open_text_format_of(const std::string& value, const Source& rainfall,
                               const std::string& beginning, Warnings& warnings) {
  if (!rainfall.layer.empty()) return {};
  if (is_usgs_rdb(beginning) && is_usgs_rain(value))
    return open_usgs(rainfall.file, value, warnings);
  const PublishedFormat* format = format_of_rows(beginning);
  if (format != nullptr && has_published_name(value, format->value))
    return open_without_header(rainfall.file, *format, rainfall.csv, warnings);
  return {};
}

/// A table whose column of values the user names: of its format where that is the format's own. Of
/// another column nothing is known, and that is said.
Recognised open_table_format_of(const std::string& value, const Source& rainfall,
                                const std::string& beginning, Warnings& warnings) {
  Recognised found = open_table_format(rainfall, beginning, warnings);
  if (found.format == nullptr || has_published_name(value, found.format->value)) return found;
  const auto& header = found.table->header();
  const std::string& rain = header[published_column(header, found.format->value).value()];
  warnings.add({rainfall.file, 0,
                "it is " + std::string(found.format->name) + ", whose rain is " + quoted(rain, 60) +
                    ": what is known of that, its unit, flags and codes, does not count for " +
                    setting("value_field", value),
                ""});
  if (found.format == &ana_format() || found.format == &hourly_order_format())
    return {open_table(rainfall, warnings)};
  return {std::move(found.table)};
}

/// Refuses a table of a known format that has no column of rain, by whatever name.
void require_rain(const Table& table, const std::string& beginning) {
  const std::vector<std::string>& header = table.header();
  if (std::ranges::any_of(header, is_called_as_values)) return;
  const std::string_view format = format_without_rain(header, beginning);
  if (format.empty()) return;
  throw NoRain({table.file(), table.header_line(),
                "it is " + std::string(format) + ", without a column of rain; the columns are " +
                    listed(header),
                setting("value_field") + " names one that is rain all the same"});
}

/// Tells which texts end within a line: the table's own, or those that it lists. Of a CSV it is
/// told already.
void tell_of_last_lines(const Table& table, const std::string& beginning, Warnings& warnings) {
  if (dynamic_cast<const CsvReader*>(&table) != nullptr) return;
  const std::string& file = table.file();
  tell_of_last_line(file, warnings);
  std::vector<std::string> listed_files;
  if (swat_file(beginning) == SwatFile::list) listed_files = files_of_swat_list(file, open_text);
  if (arcswat_file(beginning) == ArcSwatFile::list)
    listed_files = files_of_arcswat_list(file, open_text);
  for (const std::string& one : listed_files) tell_of_last_line(one, warnings);
}

Recognised open_by_content(const Source& rainfall, const ReadingsOptions& options,
                           Warnings& warnings) {
  const std::string beginning = beginning_of_text(rainfall.file, csv_beginning_bytes);
  const std::string& value = options.value_field;
  Recognised found = value.empty() ? open_text_format(rainfall, beginning, warnings)
                                   : open_text_format_of(value, rainfall, beginning, warnings);
  if (found.table) {
    tell_of_last_lines(*found.table, beginning, warnings);
    if (!rainfall.where.empty()) {
      found.table =
          keep_rows(std::move(found.table), {rainfall.where, rainfall.where_setting}, {}, warnings);
    }
    return found;
  }
  if (!value.empty()) return open_table_format_of(value, rainfall, beginning, warnings);
  found = open_table_format(rainfall, beginning, warnings);
  if (found.format == nullptr) require_rain(*found.table, beginning);
  return found;
}

/// What to do about a unit that is not known: one of a rate has no name that the option takes.
Wording hint_for_unit(const std::string& units) {
  const std::string plain = udunits_with_quotients(units);
  const bool is_rate =
      plain.find('/') != std::string::npos || plain.find("per") != std::string::npos;
  if (is_rate) return setting("scale") + " brings it to millimetres in a step";
  return setting("from_unit") + " says what it is in, or " + setting("scale") + " brings it there";
}

/// What is said of a NetCDF's variable of rain.
std::string netcdf_in_words(const NetcdfRainfall& table, const std::optional<RainUnit>& unit,
                            const ReadingsOptions& options, bool is_known) {
  std::string words =
      (is_known ? "its rain is " : "rain of a NetCDF of stations: ") + table.header()[2];
  if (unit) words += ", in " + unit->name();
  const bool is_told = unit && !options.from_unit && !options.scale;
  const std::string to = is_told ? conversion_from(*unit, options).unit : std::string();
  if (is_told && to != unit->name()) words += ", converted to " + to;
  const std::string& bounds = table.times().bounds_in_words();
  return bounds.empty() ? words : words + "; " + bounds;
}

/// Opens a NetCDF of stations, whose variable says its unit, and the bounds of its times, where
/// there are any, what these are of their steps.
RainfallTable open_netcdf(const std::string& file, ReadingsOptions options, Warnings& warnings) {
  auto table = std::make_unique<NetcdfRainfall>(file, options.value_field, warnings);
  const std::string& name = table->header()[2];
  const std::string& units = table->units();
  const auto unit = rain_unit(udunits_with_quotients(units));
  if (!units.empty() && !unit && !options.from_unit && !options.scale) {
    throw Error({file, 0,
                 "its variable " + quoted(name, 60) + " is in " + quoted(units, 40) +
                     ", which is no unit of rain that is known",
                 hint_for_unit(units)});
  }
  // Where the stations are of the same file, it was told what it is.
  const bool is_told = std::ranges::any_of(warnings.notices(), [&](const Message& notice) {
    return notice.file == file && notice.text == Wording(read_as_netcdf);
  });
  warnings.add_notice({file, 0, netcdf_in_words(*table, unit, options, is_told), ""});
  options.station_field = "station";
  options.time_fields = {"time"};
  options.value_field = name;
  options.stamp = table->times().stamp();
  if (!options.from_unit && !options.scale) options.from_unit = unit;
  return {std::move(table), std::move(options)};
}

[[noreturn]] void fail_without(const std::string& file, const std::string& what) {
  throw NoRain({file, 0, "it has no " + what, ""});
}

/// What a format has of what is read of totals. Throws NoRain where it has none.
PublishedFormat format_read(PublishedFormat format, AmountsRead read, const Table& table) {
  if (read == AmountsRead::of_steps) return format;
  const std::string_view days = std::exchange(format.period, {});
  if (read == AmountsRead::totals) return format;
  const auto has = [&](std::string_view column) {
    return !column.empty() && published_column(table.header(), column).has_value();
  };
  if (read == AmountsRead::days) {
    if (!has(days)) fail_without(table.file(), "column of days");
    format.value = days;
  } else if (format.kept == "ELEMENT=PRCP") {
    format.kept = read == AmountsRead::sums ? "ELEMENT=MDPR" : "ELEMENT=DAPR";
  } else if (format.value == "PRCP" && has("MDPR") && has("DAPR")) {
    const bool are_sums = read == AmountsRead::sums;
    format.value = are_sums ? "MDPR" : "DAPR";
    const std::string_view flags = are_sums ? "MDPR_ATTRIBUTES" : "DAPR_ATTRIBUTES";
    format.flags = !format.flags.empty() && has(flags) ? flags : std::string_view();
  } else {
    fail_without(table.file(), "sums of several days");
  }
  if (read == AmountsRead::sums) return format;
  format.marks = format.source = {};
  format.whole_numbers = false;
  return format;
}

/// Has the columns count that the user names of RAINFALL where a table of totals has them, too.
void take_columns(ReadingsOptions& options, const ReadingsOptions& named, const Table& table) {
  const auto has = [&](const std::string& name) {
    return !name.empty() && std::ranges::any_of(table.header(), [&](const std::string& column) {
      return same_name(column, name);
    });
  };
  if (has(named.station_field)) options.station_field = named.station_field;
  if (has(named.value_field)) options.value_field = named.value_field;
  if (std::ranges::all_of(named.time_fields, has)) options.time_fields = named.time_fields;
}

/// What is read of totals in a table of no known format, of which one column may be of days.
/// Throws NoRain where it has none.
RainfallTable read_unknown(std::unique_ptr<Table> table, ReadingsOptions options,
                           const ReadingsOptions& named) {
  if (options.read == AmountsRead::of_steps) return {std::move(table), std::move(options)};
  take_columns(options, named, *table);
  if (options.read == AmountsRead::totals) return {std::move(table), std::move(options)};
  const auto days = find_field(table->header(), known::gathered_days);
  const bool are_days = options.read == AmountsRead::days;
  if (!are_days || !days || find_field(table->header(), known::station_ids) == std::nullopt)
    fail_without(table->file(), are_days ? "column of days" : "sums of several days");
  options.value_field = table->header()[*days];
  return {std::move(table), std::move(options)};
}

/// Has numbers of days be read as they are, whatever the amounts beside them are in. Of totals it
/// is their format that names columns.
ReadingsOptions options_read(ReadingsOptions options) {
  if (options.read == AmountsRead::of_steps) return options;
  options.station_field.clear();
  options.value_field.clear();
  options.time_fields.clear();
  if (options.read != AmountsRead::days && options.read != AmountsRead::days_of_sums)
    return options;
  options.from_unit.reset();
  options.to_unit.reset();
  options.scale = 1;
  options.trace.clear();
  return options;
}

}  // namespace

RainfallTable open_rainfall_table(const Source& said, const ReadingsOptions& asked,
                                  Warnings& warnings) {
  const ReadingsOptions options = options_read(asked);
  Source rainfall = said;
  rainfall.file = file_of_readings(said.file, warnings);
  if (!options.keep_flagged && is_netcdf_of_stations(rainfall.file)) {
    if (options.read != AmountsRead::of_steps && options.read != AmountsRead::totals)
      fail_without(rainfall.file, "sums of several days");
    return open_netcdf(rainfall.file, options, warnings);
  }
  Recognised found = open_by_content(rainfall, options, warnings);
  if (options.keep_flagged && (found.format == nullptr || found.format->flags.empty())) {
    throw Error({rainfall.file, 0,
                 setting("keep_flagged") + " is for GHCN-Daily, whose values have flags of quality",
                 ""});
  }
  if (found.format == nullptr) return read_unknown(std::move(found.table), options, asked);
  const PublishedFormat format = format_read(*found.format, options.read, *found.table);
  tell_format(format, *found.table, options, found.tells_encoding, warnings);
  if (found.format == &hourly_order_format()) {
    warnings.add_notice({found.table->file(), 0,
                         "hours that it leaves out between two rows of a station are dry, but in "
                         "periods that its flags say are missing, deleted or summed; its times end "
                         "their hours",
                         ""});
  }
  // A column that the user names is here the format's own, which the table may call otherwise.
  ReadingsOptions others = options;
  others.value_field.clear();
  ReadingsOptions all = options_of(format, *found.table, std::move(others));
  auto table = std::make_unique<PublishedTable>(std::move(found.table), format, options, warnings);
  const bool is_of_one = found.format->station.empty() && all.station_field.empty();
  return {std::move(table), std::move(all), is_of_one, std::move(found.stations_told)};
}

}  // namespace thiessen
