#include "cli/options/blocks/period_options.h"

#include <string>

#include "base/calendar_days.h"
#include "base/error.h"
#include "base/iso_time.h"
#include "cli/options/option_values.h"
#include "cli/options/usage_error.h"
#include "rainfall/periods/period_calendar.h"

namespace thiessen::cli {

void PeriodOptions::declare_range(OptionList& options) {
  OptionGroup readings = options.group("Readings", *this);
  from_option_ = &readings.add(
      "--from", iso_time(range_.from),
      "only the steps from this time on: a year, month, day or time (ISO 8601), by the file's own "
      "clock");
  to_option_ =
      &readings.add("--to", iso_time(range_.to),
                    "only the steps up to this time, and with it: a year, month or day to its end");
}

void PeriodOptions::declare_stamp(OptionList& options, const std::string& decides) {
  stamp_option_ =
      &options.group("Readings", *this)
           .add("--stamp", choice<Stamp>(stamp_, {{"begin", Stamp::begin}, {"end", Stamp::end}}),
                "whether a time with a clock begins its step (default) or ends it: "
                "decides " +
                    decides +
                    "; --from and --to are of times as they are written; a NetCDF of "
                    "stations whose times have bounds says it itself");
}

void PeriodOptions::settle_stamp(std::optional<Stamp> known, const std::string& rainfall) {
  if (!known) return;
  if (stamp_option() != nullptr && stamp_ != *known) {
    const bool ends = *known == Stamp::end;
    throw Error({rainfall, 0,
                 std::string("it says that its times ") + (ends ? "end" : "begin") +
                     " their steps, and " + setting("stamp", ends ? "begin" : "end") +
                     " says otherwise",
                 "leave it out"});
  }
  stamp_ = *known;
}

void PeriodOptions::declare(OptionList& options) {
  declare_range(options);
  declare_stamp(options,
                "in which total a step counts (--every), which month's normals count, over which "
                "steps a total is spread (--totals), and what bounds times have in files that hold "
                "them (time_bnds)");
  OptionGroup output = options.group("Output", *this);
  every_option_ = &output.add(
      "--every", periods(every_),
      "totals over periods instead of a row a step, and beside them, in BASIN_missing, how many of "
      "the period's steps have no value or lack in the file; with --long rows "
      "time,basin,rainfall,missing. Weeks are those of ISO 8601 (2014-W05), seasons have the year "
      "of "
      "their January (2014-DJF); hours (6h) are called by the time at which they begin, and "
      "counted "
      "from --day-start, on through the days from --from (or 1970) where they do not make up a "
      "day; "
      "a storm lies between dry spells (--dry) of all basins, and is called by its first wet step "
      "(--long: last, its last one). Readings that are rates (mm/h) count times their step");
  allowed_missing_option_ =
      &output.add("--allow-missing", whole_number(allowed_missing_, 0, 1'000'000'000),
                  "with --every: how many steps without a value a total may pass over; with more "
                  "it is empty; default 0");
  declare_periods(output);
}

void PeriodOptions::declare_periods(OptionGroup& output) {
  day_start_option_ = &output.add(
      "--day-start", time_of_day(day_start_),
      "when the days begin of which --every is made: a day is called by the date on which "
      "it begins, and weeks, months, seasons and years begin with their first day; "
      "default 00:00");
  year_start_option_ =
      &output.add("--year-start", whole_number(year_start_, 1, 12),
                  "the month with which the years of --every begin; a year is called by the one in "
                  "which it ends: 10 has 2014 begin in October 2013");
  dry_option_ =
      &output.add("--dry", duration(dry_),
                  "how long it is dry in every basin between the storms of --every; default 6h");
}

void PeriodOptions::declare_depths(OptionList& options) {
  options.group("Output", *this)
      .add("--max", durations(depths_),
           "the largest depths of each basin in these lengths of time (1h, 24h, 2d, 15min), "
           "whenever they begin: columns max_24h and max_24h_time, the time of its first step, in "
           "summary.csv; of whole steps, none of which may lack");
}

void PeriodOptions::check(bool has_bounds) const {
  if (allowed_missing_option_ != nullptr && allowed_missing_option_->is_given() && !every_) {
    throw UsageError{"--allow-missing is about totals, and there is no --every",
                     "give --every day, month or year, or leave it out"};
  }
  check_periods();
  if (every_option_ != nullptr && stamp_option() != nullptr && !every_ && !has_bounds) {
    throw UsageError{"--stamp decides in which total a step counts, and there is no --every",
                     "give --every day, month or year, or leave it out: --from and --to are of "
                     "times as they are "
                     "written"};
  }
  if (range_.is_empty()) {
    throw UsageError{
        "--from " + from_option_->texts.back() + " is after --to " + to_option_->texts.back(), ""};
  }
}

void PeriodOptions::check_periods() const {
  const auto refuse = [](const Option* option, bool acts, const char* about, const char* hint) {
    if (option == nullptr || !option->is_given() || acts) return;
    throw UsageError{option->name + " is about " + about, hint};
  };
  refuse(day_start_option_, every_ && !are_storms(),
         "the periods of --every that have days or hours", "give --every day, or leave it out");
  refuse(year_start_option_, every_ && every_->unit == PeriodUnit::year, "--every year",
         "give that, or leave it out");
  refuse(dry_option_, are_storms(), "--every storm", "give that, or leave it out");
}

std::optional<Every> PeriodOptions::every() const {
  if (!every_) return std::nullopt;
  Every every = *every_;
  every.day_start = day_start_;
  every.has_day_start = day_start_option_ != nullptr && day_start_option_->is_given();
  every.year_start = static_cast<int>(year_start_);
  every.dry = dry_;
  if (range_.from)
    every.first_day = floor_quotient(clock_seconds(*range_.from) - day_start_, seconds_of_day);
  return every;
}

std::optional<StepTimes> PeriodOptions::times() const {
  if (!range_.from && !range_.to && !every_ && depths_.empty()) return std::nullopt;
  const std::optional<Every> every = this->every();
  return StepTimes{range_, every ? every->least_precision() : TimePrecision::year};
}

std::optional<Totalling> PeriodOptions::totalling() const {
  const std::optional<Every> every = this->every();
  if (!every) return std::nullopt;
  return Totalling{*every, allowed_missing_, range_, stamp_};
}

}  // namespace thiessen::cli
