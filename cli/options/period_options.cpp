#include "cli/options/period_options.h"

#include <string>

#include "base/error.h"
#include "cli/options/option_values.h"
#include "cli/options/usage_error.h"

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

void PeriodOptions::declare_stamp(OptionList& options) {
  stamp_option_ =
      &options.group("Readings", *this)
           .add(
               "--stamp", choice<Stamp>(stamp_, {{"begin", Stamp::begin}, {"end", Stamp::end}}),
               "whether a time with a clock begins its step (default) or ends it: decides in which "
               "total a step counts (--every), and what bounds times have in files that hold them "
               "(time_bnds); --from and --to are of times as they are written; a NetCDF of "
               "stations "
               "whose times have bounds says it itself");
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
  declare_stamp(options);
  OptionGroup output = options.group("Output", *this);
  every_option_ = &output.add(
      "--every",
      choice<std::optional<TimePrecision>>(every_, {{"day", TimePrecision::day},
                                                    {"month", TimePrecision::month},
                                                    {"year", TimePrecision::year}}),
      "totals over calendar periods instead of a row a step, and beside them, in "
      "BASIN_missing, how many of the period's steps have no value or lack in the file; "
      "with --long rows "
      "time,basin,rainfall,missing; readings that are rates (mm/h) count times their step");
  allowed_missing_option_ =
      &output.add("--allow-missing", whole_number(allowed_missing_, 0, 1'000'000'000),
                  "with --every: how many steps without a value a total may pass over; with more "
                  "it is empty; default 0");
}

void PeriodOptions::check(bool has_bounds) const {
  if (allowed_missing_option_ != nullptr && allowed_missing_option_->is_given() && !every_) {
    throw UsageError{"--allow-missing is about totals, and there is no --every",
                     "give --every day, month or year, or leave it out"};
  }
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

std::optional<StepTimes> PeriodOptions::times() const {
  if (!range_.from && !range_.to && !every_) return std::nullopt;
  return StepTimes{range_, every_.value_or(TimePrecision::year)};
}

std::optional<Totalling> PeriodOptions::totalling() const {
  if (!every_) return std::nullopt;
  return Totalling{*every_, allowed_missing_, range_, stamp_};
}

}  // namespace thiessen::cli
