#include "cli/inputs/summed_rates.h"

#include <optional>

#include "base/interrupt.h"
#include "files/rainfall/rainfall_file.h"
#include "rainfall/series/step_intervals.h"
#include "readings/units/rain_unit.h"

namespace thiessen::cli {
namespace {

/// Has readings that can be read only once count by the step that their times tell as they come:
/// not those of months, whose length is that of each.
void settle_as_they_come(Totalling& totalling, const StepLength& rate, const std::string& file,
                         const std::string& unit, Warnings& warnings) {
  if (rate.months > 0)
    throw rates_without_step(file, unit, "what is read only once does not tell it in time");
  totalling.rates = {rate, unit};
  warnings.add_notice({file, 0,
                       "the readings are rates in " + unit +
                           ", and count times the step that the times of the first period tell: "
                           "totals are in " +
                           std::string(rain_unit(unit)->depth),
                       ""});
}

/// The intervals between all times of RAINFALL. What is odd about it is told when it is read again.
StepIntervals intervals_of(Inputs& inputs, const StudyOptions& study,
                           const RainfallOptions& rainfall) {
  Warnings told_later;
  const auto readings = inputs.open_readings(study, rainfall, told_later);
  StepIntervals intervals;
  for (TimeStep step; readings->next(step);) {
    throw_if_interrupted();
    intervals.note(calendar_time(step.time, step.written));
  }
  return intervals;
}

/// Has readings that are rates count times their step, whose `intervals` are known where RAINFALL
/// can be read again.
void settle_rates(Totalling& totalling, const StepLength& rate, const StepIntervals& intervals,
                  const std::string& file, const std::string& unit, Warnings& warnings) {
  if (intervals.has_labels()) return;  // which have no totals: told where the first of them is read
  const std::optional<StepLength> step = intervals.step();
  if (!step) {
    throw rates_without_step(
        file, unit,
        intervals.times() < 2 ? "one time tells none" : "the times have no regular step");
  }
  totalling.depths.emplace(rate, *step);
  if (totalling.depths->are_the_values()) return;
  warnings.add_notice({file, 0,
                       "the readings are rates in " + unit + ", and count times their step of " +
                           text_of(*step) + ": totals are in " +
                           std::string(rain_unit(unit)->depth),
                       ""});
}

}  // namespace

void settle_totals(Totalling& totalling, Inputs& inputs, const StudyOptions& study,
                   const RainfallOptions& rainfall, const std::string& unit, Warnings& warnings) {
  const std::optional<RainUnit> of_readings = rain_unit(unit);
  const std::optional<StepLength> rate = of_readings ? time_of_rate(*of_readings) : std::nullopt;
  const bool storms = totalling.every.unit == PeriodUnit::storm;
  if (rainfall.is_event() || (!rate && !storms)) return;
  const std::string file = rainfall.name();
  if (!can_be_read_again(rainfall.request(study.csv()))) {
    if (rate) settle_as_they_come(totalling, *rate, file, unit, warnings);
    return;
  }
  const StepIntervals intervals = intervals_of(inputs, study, rainfall);
  if (storms) totalling.step = intervals.step().value_or(StepLength{});
  if (rate) settle_rates(totalling, *rate, intervals, file, unit, warnings);
}

std::string unit_of_values(const std::string& unit, const std::optional<Totalling>& totalling) {
  const std::optional<RainUnit> known = rain_unit(unit);
  const bool are_depths = totalling && (totalling->depths || totalling->rates);
  return are_depths && known ? std::string(known->depth) : unit;
}

}  // namespace thiessen::cli
