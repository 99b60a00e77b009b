#include "cli/options/blocks/rainfall_options.h"

#include <algorithm>
#include <vector>

#include "cli/options/blocks/period_options.h"
#include "cli/options/option_values.h"
#include "cli/options/usage_error.h"

namespace thiessen::cli {

void RainfallOptions::declare(OptionList& options, Need need, const std::string& stations) {
  Option& argument =
      options.group("Files", *this)
          .add("RAINFALL", file(rainfall_),
               "readings, wide or long: CSV or any of these as a table; - reads standard input; "
               "GHCN-Daily: a .dly file; or a folder of files, which are joined");
  argument.need = need;
  stations_ = &stations;
  declare_meaning(options);
  OptionValue value = texts(repeated_, "FILE");
  value.completion = Completion::file;
  const Option& repeated = options.group("Files", *this)
                               .add("--rainfall", std::move(value),
                                    "one of several files, in place of RAINFALL; repeated: they "
                                    "are joined in time and by "
                                    "station, which may stand in a file's name");
  argument.instead = {options.find("--value-field"), &repeated};
}

void RainfallOptions::declare_as_option(OptionList& options, const std::string& group,
                                        const std::string& name, const std::string& help) {
  OptionValue value = texts(repeated_, "RAINFALL");
  value.completion = Completion::file;
  options.group(group, *this).add(name, std::move(value), help);
  OptionValue further = texts(repeated_, "FILE");
  further.completion = Completion::file;
  options.group(group, *this)
      .add("--rainfall", std::move(further),
           "one of several files, in place of " + name +
               " or beside it; repeated: they are joined "
               "in time and by station, as `rain` joins them");
  declare_meaning(options);
}

void RainfallOptions::declare_meaning(OptionList& options) {
  OptionGroup readings = options.group("Readings", *this);
  declare_rows(readings);
  csv_.declare_for(readings, "RAINFALL");
  readings.add("--missing", texts(readings_.missing, "V"),
               "a further text or number that means no reading; may be repeated");
  readings.add("--trace", texts(readings_.trace, "V"),
               "a further text or number that means 0; may be repeated");
  of_tables_.push_back(&readings.add(
      "--time-field", texts(readings_.time_fields, "FIELD"),
      "the time's column; repeated for several, such as year, month and day, or date and "
      "clock; a number in a file without a header"));
  of_tables_.push_back(&readings.add(
      "--time-format", time_format(readings_.time_format),
      "how times are written, such as '%d/%m/%Y %H:%M', or excel for serial numbers; else "
      "ISO 8601, and what can be read in one way only"));
  of_tables_.push_back(&readings.add("--station-field", text(readings_.station_field, "FIELD"),
                                     "the station's column in a long table"));
  readings.add("--value-field", text(readings_.value_field, "FIELD"),
               stations_ == nullptr ? "the reading's column in a long table"
                                    : "the reading's column in a long table; without RAINFALL: "
                                      "the field of STATIONS that holds the readings of one event");
  of_tables_.push_back(
      &readings.add("--ignore-unknown", flag(readings_.ignore_unknown),
                    "pass over readings of stations that STATIONS lacks, with a warning"));
  of_tables_.push_back(
      &readings.add("--ids-as-numbers", flag(readings_.ids_as_numbers),
                    "ids of digits that differ by leading zeros are one: 52220 and 052220"));
  of_tables_.push_back(
      &readings.add("--keep-flagged", flag(readings_.keep_flagged),
                    "of GHCN-Daily, also the values that failed a check of quality"));
  declare_amounts(readings);
  exclude_option_ = &readings.add(
      "--exclude", file(exclude_, "FILE"),
      "readings that count as missing: CSV with columns station and time, as check -o writes "
      "them; a row without a time means the whole gauge");
  totals_.declare(options);
}

void RainfallOptions::declare_rows(OptionGroup& readings) {
  of_tables_.push_back(
      &readings.add("--rainfall-layer", text(layer_, "LAYER"),
                    "which layer or sheet of RAINFALL, where the file has several"));
  of_tables_.push_back(&readings.add(
      "--rainfall-where", text(where_, "SQL"),
      "only the rows of RAINFALL that meet this OGR attribute filter, such as \"ELEMENT='PRCP'\"; "
      "in a CSV a field is of numbers where the first 64 kB hold nothing else in it"));
}

void RainfallOptions::declare_amounts(OptionGroup& readings) {
  readings.add(
      "--from-unit", rain_unit_of(readings_.from_unit),
      "what the readings are in; else the unit in their column's name (prcp_in), below it, in "
      "a column unit or in a line above the header is believed");
  readings.add("--to-unit", rain_unit_of(readings_.to_unit),
               "what they are brought to where their unit is known; default mm");
  scale_option_ =
      &readings.add("--scale", number(scale_, above_zero), "multiply the readings by this instead");
  of_tables_.push_back(&readings.add(
      "--cumulative", flag(readings_.cumulative),
      "readings are counters: a step is the difference, the first has none, a fall is a reset"));
}

void RainfallOptions::check() const {
  const Option* option = first_given();
  if (!given() && option != nullptr) {
    throw UsageError{option->name + " is about readings, and there is no RAINFALL",
                     "give RAINFALL, or leave it out"};
  }
  check_files();
  if (is_event()) check_event();
  totals_.check(given(), is_event());
  check_units();
}

void RainfallOptions::check_files() const {
  if (!rainfall_.empty() && !repeated_.empty()) {
    throw UsageError{"--rainfall stands in place of RAINFALL, and both are given",
                     "name all files with --rainfall"};
  }
  if (repeated_.size() > 1 && std::find(repeated_.begin(), repeated_.end(), "-") != repeated_.end())
    throw UsageError{"--rainfall - is standard input, which stands alone", "give files"};
}

/// Refuses what an event has no use for.
void RainfallOptions::check_event() const {
  for (const Option* option : of_tables_) {
    if (!option->is_given()) continue;
    throw UsageError{option->name +
                         " is about RAINFALL, and with --value-field alone the readings "
                         "stand in STATIONS",
                     "give RAINFALL, or leave it out"};
  }
}

void RainfallOptions::check_units() const {
  if (!scale_option_->is_given() || (!readings_.from_unit && !readings_.to_unit)) return;
  throw UsageError{"--scale multiplies whatever the unit is, and " +
                       std::string(readings_.from_unit ? "--from-unit" : "--to-unit") +
                       " names one",
                   "leave one of them out"};
}

const Option* RainfallOptions::first_given() const {
  const Option* const of_readings = OptionBlock::first_given();
  return of_readings != nullptr ? of_readings : totals_.first_given();
}

Stamp RainfallOptions::stamp() const {
  return periods_ != nullptr ? periods_->stamp() : totals_.stamp();
}

std::string RainfallOptions::name() const {
  if (is_event()) return *stations_;
  return given() ? request({}).name() : "";
}

std::vector<std::string> RainfallOptions::files() const {
  if (!repeated_.empty()) return repeated_;
  return rainfall_.empty() ? std::vector<std::string>() : std::vector{rainfall_};
}

std::vector<std::string> RainfallOptions::files_beside(std::vector<std::string> others) const {
  const std::vector<std::string> own = files();
  others.insert(others.end(), own.begin(), own.end());
  if (totals_.given()) others.push_back(totals_.file());
  if (!exclude_.empty()) others.push_back(exclude_);
  return others;
}

RainfallRequest RainfallOptions::request(const CsvDialect& all) const {
  Source source;
  source.layer = layer_;
  source.where = where_;
  source.layer_setting = "rainfall_layer";
  source.where_setting = "rainfall_where";
  source.csv = csv(all);
  return {files(), source};
}

CsvDialect RainfallOptions::csv(const CsvDialect& all) const {
  CsvDialect said = csv_.or_else(all);
  said.input = "rainfall";
  std::vector<std::string> columns = readings_.time_fields;
  columns.insert(columns.end(), {readings_.station_field, readings_.value_field});
  said.numbers = readings_.time_fields.empty() ? std::vector<std::string>() : numbers_in(columns);
  return said;
}

ReadingsOptions RainfallOptions::readings(const CsvDialect& all) const {
  ReadingsOptions options = readings_;
  options.decimal_comma = csv(all).decimal_comma;
  if (is_event()) options.input = "stations";
  if (scale_option_->is_given()) options.scale = scale_;
  options.is_beside_others = totals_.given();
  return options;
}

}  // namespace thiessen::cli
