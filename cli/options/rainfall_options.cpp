#include "cli/options/rainfall_options.h"

#include "cli/options/option_values.h"
#include "cli/options/usage_error.h"

namespace thiessen::cli {

void RainfallOptions::declare(OptionList& options, Need need) {
  options.group("Files", *this)
      .add("RAINFALL", file(rainfall),
           "readings, wide or long: CSV or any of these as a table; - reads standard input; or "
           "GHCN-Daily: a .dly file, or a folder of them")
      .need = need;
  declare_meaning(options);
}

void RainfallOptions::declare_as_option(OptionList& options, const std::string& group,
                                        const std::string& name, const std::string& help) {
  OptionValue value = text(rainfall, "RAINFALL");
  value.completion = Completion::file;
  options.group(group, *this).add(name, std::move(value), help);
  declare_meaning(options);
}

void RainfallOptions::declare_meaning(OptionList& options) {
  OptionGroup readings = options.group("Readings", *this);
  readings.add("--missing", texts(readings_.missing, "V"),
               "a further text or number that means no reading; may be repeated");
  readings.add("--trace", texts(readings_.trace, "V"),
               "a further text or number that means 0; may be repeated");
  readings.add("--time-field", text(readings_.time_field, "FIELD"), "the time's column");
  readings.add("--station-field", text(readings_.station_field, "FIELD"),
               "the station's column in a long table");
  readings.add("--value-field", text(readings_.value_field, "FIELD"),
               "the reading's column in a long table");
  readings.add("--ignore-unknown", flag(readings_.ignore_unknown),
               "pass over readings of stations that STATIONS lacks, with a warning");
  readings.add("--ids-as-numbers", flag(readings_.ids_as_numbers),
               "ids of digits that differ by leading zeros are one: 52220 and 052220");
  readings.add("--keep-flagged", flag(readings_.keep_flagged),
               "of .dly files, also the values that failed a check of quality");
}

void RainfallOptions::check() const {
  const Option* option = first_given();
  if (given() || option == nullptr) return;
  throw UsageError{option->name + " is about readings, and there is no RAINFALL",
                   "give RAINFALL, or leave it out"};
}

ReadingsOptions RainfallOptions::readings(bool decimal_comma) const {
  ReadingsOptions options = readings_;
  options.decimal_comma = decimal_comma;
  return options;
}

}  // namespace thiessen::cli
