#include "cli/options/blocks/totals_options.h"

#include <utility>
#include <vector>

#include "cli/options/blocks/csv_options.h"
#include "cli/options/option_values.h"
#include "cli/options/usage_error.h"

namespace thiessen::cli {

void TotalsOptions::declare(OptionList& options) {
  OptionGroup group = options.group("Readings", *this);
  group.add("--totals", cli::file(file_, "FILE"),
            "totals of other gauges, daily beside an hourly RAINFALL: any format of readings, or a "
            "folder; each is spread over its steps as the 8 nearest gauges that report had their "
            "rain, by inverse squared distance; evenly where these were dry; sums of several days "
            "too (GHCN's MDPR, a column days)");
  group.add("--observed-at", clock_time(observed_at_),
            "the hour at which totals are read that are dated without one: the total of D ends "
            "then on D; 24:00 where they are of whole days");
  observed_day_option_ =
      &group.add("--observed-day", choice<bool>(before_, {{"same", false}, {"before", true}}),
                 "whether a total of D is read on D (default), or D is the day on which it began "
                 "and it is read the day after");
  group.add(
      "--totals-time-format", time_format(time_format_),
      "how the times of the totals are written, as --time-format; their columns have the usual "
      "names, or those that are said of RAINFALL");
  group.add("--totals-unit", rain_unit_of(unit_),
            "what the totals are in, where no column says it; they are brought to --to-unit");
}

void TotalsOptions::declare_stamp(OptionList& options) {
  options.group("Readings", *this)
      .add("--stamp", choice<Stamp>(stamp_, {{"begin", Stamp::begin}, {"end", Stamp::end}}),
           "whether a time with a clock begins its step (default) or ends it: decides over which "
           "steps a total is spread (--totals)");
}

void TotalsOptions::check(bool has_rainfall, bool is_event) const {
  const Option* const option = first_given();
  if (option == nullptr) return;
  if (!given()) {
    throw UsageError{option->name + " is about totals beside RAINFALL, and there are none",
                     "give --totals, or leave it out"};
  }
  if (!has_rainfall || is_event) {
    throw UsageError{"--totals is spread over the steps of RAINFALL, and there is none",
                     "give RAINFALL, or leave it out"};
  }
  if (file_ == "-") {
    throw UsageError{"--totals is read more than once, and standard input can be read once",
                     "give a file; RAINFALL may be -"};
  }
  if (observed_day_option_->is_given() && !observed_at_) {
    throw UsageError{
        "--observed-day says on which day totals are read, and nothing says at what "
        "hour",
        "give --observed-at, or leave it out"};
  }
}

RainfallRequest TotalsOptions::request(const RainfallRequest& rainfall,
                                       const CsvDialect& all) const {
  Source source;
  source.layer_setting = "totals";
  source.where_setting = "totals";
  source.csv = all;
  source.csv.input.clear();
  return {{file_}, source, rainfall.beside};
}

ReadingsOptions TotalsOptions::readings(const ReadingsOptions& rainfall,
                                        const CsvDialect& all) const {
  ReadingsOptions options;
  options.time_fields = rainfall.time_fields;
  options.station_field = rainfall.station_field;
  options.value_field = rainfall.value_field;
  options.time_format = time_format_;
  options.missing = rainfall.missing;
  options.trace = rainfall.trace;
  options.decimal_comma = all.decimal_comma;
  options.from_unit = unit_;
  options.to_unit = rainfall.to_unit;
  options.keep_flagged = rainfall.keep_flagged;
  options.ignore_unknown = rainfall.ignore_unknown;
  options.ids_as_numbers = rainfall.ids_as_numbers;
  options.column_of = rainfall.column_of;
  return options;
}

ObservationHour TotalsOptions::hour(Stamp stamp) const {
  return {observed_at_, before_, stamp};
}

}  // namespace thiessen::cli
