#include "readings/totals/totalled_readings.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <limits>
#include <utility>

#include "base/counted.h"
#include "base/interrupt.h"
#include "base/utf8.h"
#include "rainfall/series/step_months.h"
#include "rainfall/series/time_bounds.h"
#include "readings/stations/named_stations.h"
#include "readings/units/rain_unit.h"

namespace thiessen {
namespace {

constexpr int end_of_day = 1'440;  // minutes
constexpr std::int64_t never = std::numeric_limits<std::int64_t>::min();
constexpr std::size_t longest_shown = 80;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// The bounds of a step, by its own clock or as moments.
TimeBounds bounds(IsoTime time, bool is_by_clock, const std::optional<StepLength>& step,
                  Stamp stamp) {
  if (is_by_clock) time.ahead_of_utc.reset();
  return bounds_of({&time, 1}, step, stamp).front();
}

std::string of_station(const Station& station, const std::string& time) {
  return "of station " + quoted(station.id, longest_shown) + " at " + quoted(time, longest_shown);
}

}  // namespace

TotalledReadings::TotalledReadings(std::unique_ptr<Readings> fine, std::string file,
                                   TotalsSource totals, const ObservationHour& hour,
                                   const Weighing& weighing, Warnings& warnings)
    : fine_(std::move(fine)),
      file_(std::move(file)),
      source_(std::move(totals)),
      hour_(hour),
      weighing_(weighing),
      warnings_(warnings),
      surroundings_(weighing),
      latest_clock_(never),
      latest_moment_(never),
      until_(weighing.network().stations().size(), {never, "", 0}),
      have_totals_(until_.size()),
      with_totals_(until_.size()) {
  if (const auto said = fine_->stamp()) hour_.stamp = *said;
  for (std::uint32_t s = 0; s < until_.size(); ++s) silent_.push_back(StationIndex{s});
}

bool TotalledReadings::next(TimeStep& step) {
  while (!is_ready()) read_on();
  if (held_.empty()) {
    conclude();
    return false;
  }
  given_ = std::move(held_.front());
  held_.pop_front();
  step = given_.step;
  step.readings = given_.readings;
  return true;
}

bool TotalledReadings::is_waiting(std::chrono::milliseconds patience) {
  while (!is_ready()) {
    if (fine_->is_waiting(patience)) return true;
    read_on();
  }
  return false;
}

/// Whether all totals that the first step held is part of are spread.
bool TotalledReadings::is_ready() const {
  if (fine_ended_) return true;
  if (held_.empty()) return false;
  if (totals_ && !has_ahead_) return true;
  const Held& first = held_.front();
  return latest_clock_ >= first.clock + survey_.longest &&
         latest_moment_ >= first.moment + survey_.longest;
}

/// Reads the next fine step, and spreads what has ended by then.
void TotalledReadings::read_on() {
  throw_if_interrupted();
  TimeStep step;
  if (fine_->next(step)) {
    hold(step);
  } else {
    fine_ended_ = true;
  }
  if (!totals_) begin();
  spread_what_has_ended();
}

/// Looks through the totals and opens them, once the first fine step is known.
void TotalledReadings::begin() {
  // Days in days begin and end together, whenever that may be.
  if (!has_clock_ && !hour_.minutes) hour_.minutes = end_of_day;
  survey_ = look_through(source_);
  totals_.emplace(source_, hour_, survey_, warnings_);
  require_units_alike();
  has_ahead_ = totals_->next(ahead_);
}

void TotalledReadings::require_units_alike() const {
  const std::string of_fine = fine_->unit();
  const std::string of_totals = totals_->unit();
  const auto unit = rain_unit(of_fine);
  if (unit && time_of_rate(*unit)) {
    throw Error({file_, 0, "its readings are rates in " + of_fine + ", and totals are depths",
                 setting("scale") + " by the length of a step makes depths of them, " +
                     setting("from_unit", std::string(unit->depth)) + " says that they are some"});
  }
  if (of_fine == of_totals) return;
  if (!of_fine.empty() && !of_totals.empty()) {
    throw Error({source_.name, 0,
                 "the totals are in " + of_totals + ", and the readings of " +
                     quoted(file_, longest_shown) + " in " + of_fine,
                 setting("to_unit") + " brings both to one unit"});
  }
  const bool is_of_totals = of_totals.empty();
  warnings_.add_notice(
      {is_of_totals ? source_.name : file_, 0,
       std::string("nothing says what ") + (is_of_totals ? "the totals" : "the readings") +
           " are in: they are taken to be in " + (is_of_totals ? of_fine : of_totals) + ", as " +
           quoted(is_of_totals ? file_ : source_.name, longest_shown) + " is",
       ""});
}

/// Requires a time of the calendar that is after that of the step before.
void TotalledReadings::require_calendar(const TimeStep& step) {
  const ParsedTime parsed = calendar_time(step.time, step.written);
  if (!parsed) {
    const bool has_words = step.written && !step.written->fault.empty();
    throw Error(
        {file_, step.line,
         "time " + quoted(step.time, longest_shown) +
             (has_words ? step.written->fault : Wording(" is not one of the calendar")) +
             ", and totals are spread by the times of steps",
         has_words ? step.written->hint : setting("time_format") + " says how times are written"});
  }
  intervals_.note(parsed);
  if (before_ && order_of_moments(parsed.time, *before_) != std::strong_ordering::greater) {
    throw Error({file_, step.line,
                 "time " + quoted(step.time, longest_shown) + " comes after " +
                     quoted(text_before_, longest_shown) +
                     ", and totals are spread in the order of time",
                 "sort the file by its times"});
  }
  if (!first_) first_ = parsed.time;
  if (!before_) has_clock_ = parsed.time.precision == TimePrecision::instant;
  before_ = parsed.time;
  text_before_ = step.time;
}

void TotalledReadings::hold(const TimeStep& step) {
  require_calendar(step);
  Held held;
  held.step = step;
  held.readings.assign(step.readings.begin(), step.readings.end());
  const NormalField* const normals = weighing_.normals();
  if (normals != nullptr && normals->months() > 1)
    held.month = StepMonths(file_, hour_.stamp).of(step.time, step.written, step.line);
  held.by_place = surroundings_.by_place(held.readings, held.month);
  held.is_reported = std::any_of(held.by_place.begin(), held.by_place.end(),
                                 [](double rain) { return !std::isnan(rain); });
  std::erase_if(silent_,
                [&](StationIndex station) { return !std::isnan(held.readings[index(station)]); });
  held.clock = clock_seconds(*before_);
  held.moment = moment_seconds(*before_);
  latest_clock_ = std::max(latest_clock_, held.clock);
  latest_moment_ = std::max(latest_moment_, held.moment);
  held_.push_back(std::move(held));
}

void TotalledReadings::spread_what_has_ended() {
  while (has_ahead_) {
    const std::int64_t latest = ahead_.is_by_clock ? latest_clock_ : latest_moment_;
    if (!fine_ended_ && latest < ahead_.period.end) return;
    check_overlap(ahead_);
    if (overlaps_.empty()) spread(ahead_);
    has_ahead_ = totals_->next(ahead_);
    // All that overlap are told together.
    while (has_ahead_ && !overlaps_.empty()) {
      check_overlap(ahead_);
      has_ahead_ = totals_->next(ahead_);
    }
  }
  overlaps_.throw_if_any();
}

void TotalledReadings::check_overlap(const PeriodTotals& totals) {
  for (const PeriodTotals::Amount& total : totals.amounts) {
    Until& until = until_[index(total.station)];
    if (until.end > totals.period.begin) {
      const std::string where = until.line > 0 ? " in line " + std::to_string(until.line) : "";
      overlaps_.add(
          {source_.name, totals.line,
           "the total " +
               of_station(weighing_.network().stations()[index(total.station)], totals.time) +
               " begins before that at " + quoted(until.time, longest_shown) + where + " ends",
           "keep the one that is right"});
    }
    until = {std::max(until.end, totals.period.end), totals.time, totals.line};
  }
}

std::int64_t TotalledReadings::at(const Held& held, const PeriodTotals& totals) const {
  return totals.is_by_clock ? held.clock : held.moment;
}

/// The steps held that are part of a period.
TotalledReadings::Steps TotalledReadings::steps_of(const PeriodTotals& totals) const {
  const bool ends = hour_.stamp == Stamp::end && has_clock_;
  const auto is_within = [&](const Held& held) {
    const std::int64_t time = at(held, totals);
    return ends ? time > totals.period.begin && time <= totals.period.end
                : time >= totals.period.begin && time < totals.period.end;
  };
  const auto first = std::find_if(held_.begin(), held_.end(), is_within);
  const auto last = std::find_if_not(first, held_.end(), is_within);
  return {static_cast<std::size_t>(first - held_.begin()),
          static_cast<std::size_t>(last - held_.begin())};
}

bool TotalledReadings::is_covered(const PeriodTotals& totals) const {
  if (!first_) return false;
  const std::optional<StepLength> step = intervals_.step();
  const auto begin = static_cast<double>(totals.period.begin);
  const auto end = static_cast<double>(totals.period.end);
  return bounds(*first_, totals.is_by_clock, step, hour_.stamp).begin <= begin &&
         (!fine_ended_ || bounds(*before_, totals.is_by_clock, step, hour_.stamp).end >= end);
}

/// Refuses a total that begins or ends within a step: nothing tells how much of that is its own.
void TotalledReadings::require_steps_end(const PeriodTotals& totals, std::int64_t boundary) const {
  const auto after = std::find_if(held_.begin(), held_.end(),
                                  [&](const Held& held) { return at(held, totals) >= boundary; });
  if (after == held_.begin() || (after != held_.end() && at(*after, totals) == boundary)) return;
  const bool ends = hour_.stamp == Stamp::end && has_clock_;
  if (ends && after == held_.end()) return;
  const Held& step = ends ? *after : *(after - 1);
  const IsoTime time = calendar_time(step.step.time, step.step.written).time;
  const TimeBounds of_step = bounds(time, totals.is_by_clock, intervals_.step(), hour_.stamp);
  const auto at_boundary = static_cast<double>(boundary);
  if (at_boundary <= of_step.begin || at_boundary >= of_step.end) return;
  throw Error({source_.name, totals.line,
               "the total of " + quoted(totals.time, longest_shown) +
                   (boundary == totals.period.end ? " ends" : " begins") + " at " +
                   time_text(boundary, TimePrecision::instant) + ", within the step " +
                   quoted(step.step.time, longest_shown) + " of " + quoted(file_, longest_shown),
               setting("observed_at") + " says when totals are read, and " + input("rainfall") +
                   " is the one of finer steps"});
}

void TotalledReadings::require_zones_alike(const PeriodTotals& totals) const {
  if (totals.is_by_clock || !before_) return;
  if (totals.has_zone == before_->ahead_of_utc.has_value()) return;
  throw Error(
      {source_.name, totals.line,
       "time " + quoted(totals.time, longest_shown) +
           (totals.has_zone ? " has a zone, and those of " : " has no zone, and those of ") +
           quoted(file_, longest_shown) + (totals.has_zone ? " have none" : " have one"),
       "write all times with a zone, or none"});
}

void TotalledReadings::spread(const PeriodTotals& totals) {
  require_zones_alike(totals);
  const Steps steps = steps_of(totals);
  const bool is_there = steps.begin < steps.end && is_covered(totals);
  if (is_there) {
    require_steps_end(totals, totals.period.begin);
    require_steps_end(totals, totals.period.end);
  }
  for (const PeriodTotals::Amount& total : totals.amounts) {
    have_totals_[index(total.station)] = true;
    if (is_there) {
      spread(totals, total, steps);
    } else {
      note(beyond_, totals, total);
    }
  }
}

void TotalledReadings::spread(const PeriodTotals& totals, const PeriodTotals::Amount& total,
                              const Steps& steps) {
  const std::size_t station = index(total.station);
  around_.clear();
  for (std::size_t i = steps.begin; i < steps.end; ++i) {
    const Held& held = held_[i];
    if (!std::isnan(held.readings[station])) return note(own_, totals, total);
    // How nothing is spread does not matter.
    around_.push_back(total.amount > 0 ? surroundings_.at(total.station, held.by_place, held.month)
                                       : (held.is_reported ? 0 : unknown));
  }
  amounts_.resize(around_.size());
  const SpreadBy by = spread_total(total.amount, around_, amounts_);
  for (std::size_t i = steps.begin; i < steps.end; ++i)
    held_[i].readings[station] = amounts_[i - steps.begin];
  note(spread_, totals, total);
  with_totals_[station] = true;
  if (total.amount == 0) return;
  if (by == SpreadBy::evenly_dry) note(dry_, totals, total);
  if (by == SpreadBy::evenly_unreported) note(unreported_, totals, total);
}

void TotalledReadings::note(TotalsTold& count, const PeriodTotals& totals,
                            const PeriodTotals::Amount& total) const {
  if (count.count++ > 0) return;
  count.first = of_station(weighing_.network().stations()[index(total.station)], totals.time);
  count.line = totals.line;
}

void TotalledReadings::conclude() {
  if (std::exchange(has_concluded_, true)) return;
  const auto gauges =
      static_cast<std::size_t>(std::count(with_totals_.begin(), with_totals_.end(), true));
  if (spread_.count > 0) {
    warnings_.add_notice({source_.name, 0,
                          counted(spread_.count, "total of ", "totals of ") +
                              counted(gauges, "gauge") + " " + (spread_.count == 1 ? "is" : "are") +
                              " spread as the nearest gauges of " + quoted(file_, longest_shown) +
                              " had their rain",
                          ""});
  }
  tell_silent();
  tell(dry_, "spread evenly, for it was dry at the gauges around");
  tell(unreported_, "spread evenly, for no gauge reported in the whole period");
  tell(own_, "passed over, for the gauge reports in " + quoted(file_, longest_shown) +
                 " within the period");
  tell(beyond_,
       "left out, for the steps of " + quoted(file_, longest_shown) + " do not cover the period");
  if (totals_->without_days() > 0) {
    warnings_.add(
        {source_.name, 0,
         counted(totals_->without_days(), "sum of several days is", "sums of several days are") +
             " left out, for nothing tells of how many",
         ""});
  }
}

/// Tells which gauges have neither readings nor totals.
void TotalledReadings::tell_silent() const {
  std::vector<std::string> first;
  std::size_t silent = 0;
  for (const StationIndex station : silent_) {
    if (have_totals_[index(station)]) continue;
    if (++silent <= stations_named)
      first.push_back(weighing_.network().stations()[index(station)].id);
  }
  if (silent > 0) warnings_.add({file_, 0, without_readings(first, silent, ""), ""});
}

void TotalledReadings::tell(const TotalsTold& count, const std::string& what) const {
  if (count.count == 0) return;
  const std::size_t more = count.count - 1;
  const std::string others = more == 0   ? ""
                             : more == 1 ? ", and so is 1 more"
                                         : ", and so are " + std::to_string(more) + " more";
  warnings_.add(
      {source_.name, count.line, "the total " + count.first + " is " + what + others, ""});
}

}  // namespace thiessen
