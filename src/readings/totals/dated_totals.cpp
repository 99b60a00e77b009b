#include "readings/totals/dated_totals.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <utility>

#include "base/calendar_days.h"
#include "base/interrupt.h"
#include "base/number.h"
#include "base/utf8.h"
#include "rainfall/series/step_intervals.h"

namespace thiessen {
namespace {

constexpr double most_days = 3'660;

IsoTime time_of(const TimeStep& step, const std::string& file) {
  const ParsedTime parsed = calendar_time(step.time, step.written);
  if (parsed) return parsed.time;
  const bool has_words = step.written && !step.written->fault.empty();
  throw Error({file, step.line,
               "time " + quoted(step.time, 80) +
                   (has_words ? step.written->fault : Wording(" is not one of the calendar")) +
                   ", and totals are spread by their times",
               has_words
                   ? step.written->hint + "; of totals that is " + setting("totals_time_format")
                   : setting("totals_time_format") + " says how their times are written"});
}

bool is_before(const IsoTime& a, const IsoTime& b) {
  return order_of_moments(a, b) == std::strong_ordering::less;
}

/// A number of days that a column says.
int whole_days(double days, const TimeStep& step, const std::string& file) {
  if (days >= 1 && days <= most_days && std::abs(days - std::round(days)) < 1e-9)
    return static_cast<int>(std::lround(days));
  throw Error({file, step.line,
               "the total of " + quoted(step.time, 80) + " is said to be of " +
                   shortest_text(days) + " days",
               "days are whole, and 1 or more"});
}

/// The longest period of totals of one step.
std::int64_t longest_of(TimePrecision precision, const std::optional<StepLength>& step) {
  if (precision == TimePrecision::year) return 366 * seconds_of_day;
  if (precision == TimePrecision::month) return 31 * seconds_of_day;
  if (!step) return seconds_of_day;
  return step->months > 0 ? step->months * 31 * seconds_of_day
                          : std::max(seconds_of_day, step->seconds);
}

}  // namespace

TotalsSurvey look_through(const TotalsSource& source) {
  TotalsSurvey survey;
  Warnings told_later;
  for (const TotalsPart& part : source.open(false, told_later)) {
    StepIntervals intervals;
    std::optional<IsoTime> before;
    TimePrecision precision = TimePrecision::instant;
    for (TimeStep step; part.amounts->next(step);) {
      throw_if_interrupted();
      const IsoTime time = time_of(step, source.name);
      intervals.note({time, IsoTimeFault::none});
      precision = std::min(precision, time.precision);
      survey.ascends = survey.ascends && (!before || is_before(*before, time));
      before = time;
    }
    if (!survey.step) survey.step = intervals.step();
    if (before) survey.longest = std::max(survey.longest, longest_of(precision, survey.step));
    for (TimeStep step; part.days && part.days->next(step);) {
      throw_if_interrupted();
      for (const double days : step.readings) {
        if (std::isnan(days)) continue;
        survey.longest =
            std::max(survey.longest, whole_days(days, step, source.name) * seconds_of_day);
      }
    }
  }
  return survey;
}

DatedTotals::DatedTotals(const TotalsSource& source, ObservationHour hour,
                         const TotalsSurvey& survey, Warnings& warnings)
    : file_(source.name) {
  for (TotalsPart& part : source.open(!survey.ascends, warnings)) {
    Part& last = parts_.emplace_back();
    last.readings = std::move(part);
    last.has_days = last.readings.days && last.readings.days->next(last.days);
    if (last.has_days) last.time_of_days = time_of(last.days, file_);
    advance(last);
  }
  if (const auto said = parts_.front().readings.amounts->stamp()) hour.stamp = *said;
  periods_.emplace(hour, survey.step);
}

void DatedTotals::advance(Part& part) {
  part.has_step = part.readings.amounts->next(part.step);
  if (part.has_step) part.time = time_of(part.step, file_);
  // The days of what has no amount are nobody's.
  while (part.has_step && part.has_days && is_before(part.time_of_days, part.time)) {
    part.has_days = part.readings.days->next(part.days);
    if (part.has_days) part.time_of_days = time_of(part.days, file_);
  }
}

DatedTotals::Part* DatedTotals::earliest() {
  Part* first = nullptr;
  for (Part& part : parts_) {
    if (part.has_step && (first == nullptr || is_before(part.time, first->time))) first = &part;
  }
  return first;
}

bool DatedTotals::next(PeriodTotals& totals) {
  while (ready_.empty()) {
    Part* const part = earliest();
    if (part == nullptr) return false;
    take(*part);
    advance(*part);
  }
  totals = std::move(ready_.back());
  ready_.pop_back();
  return true;
}

/// The number of days that an amount is of: 0 for one of the file's step, less where nothing tells.
int DatedTotals::days_of(Part& part, std::size_t station) const {
  if (!part.readings.days) return 0;
  const bool is_told = part.has_days && !is_before(part.time, part.time_of_days) &&
                       !std::isnan(part.days.readings[station]);
  if (is_told) return whole_days(part.days.readings[station], part.days, file_);
  return part.readings.is_of_step_without_days ? 1 : -1;
}

/// Sorts the amounts of a step by how many days they are of.
void DatedTotals::take(Part& part) {
  std::vector<int> days_ready;
  for (std::uint32_t s = 0; s < part.step.readings.size(); ++s) {
    const double amount = part.step.readings[s];
    if (std::isnan(amount)) continue;
    const int days = days_of(part, s);
    if (days < 0) {
      ++without_days_;
      continue;
    }
    auto at = std::find(days_ready.begin(), days_ready.end(), days);
    if (at == days_ready.end()) {
      at = days_ready.insert(days_ready.end(), days);
      PeriodTotals& fresh = ready_.emplace_back();
      fresh.period = periods_->of(part.time, days, part.step.time, file_, part.step.line);
      fresh.is_by_clock = periods_->is_by_clock(part.time);
      fresh.has_zone = part.time.ahead_of_utc.has_value();
      fresh.time = part.step.time;
      fresh.line = part.step.line;
    }
    ready_[static_cast<std::size_t>(at - days_ready.begin())].amounts.push_back(
        {StationIndex{s}, amount});
  }
}

}  // namespace thiessen
