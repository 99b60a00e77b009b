#include "rainfall/series/rain_periods.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.h"
#include "base/utf8.h"
#include "rainfall/series/dated_readings.h"

namespace thiessen {
namespace {

constexpr std::int64_t day_seconds = 86'400;
// Where more periods than these have no step, a time is more likely mistyped than a gauge silent.
constexpr std::int64_t most_absent = 100'000;
constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

IsoTime month_of(std::int64_t number) {
  IsoTime time;
  time.precision = TimePrecision::month;
  time.year = static_cast<int>(number / 12);
  time.month = static_cast<int>(number % 12) + 1;
  return time;
}

int days_in_month(const IsoTime& time) {
  const std::chrono::year_month_day_last last(
      std::chrono::year(time.year) / std::chrono::month(static_cast<unsigned>(time.month)) /
      std::chrono::last);
  return static_cast<int>(static_cast<unsigned>(last.day()));
}

/// How many whole numbers k have low <= anchor + k * length < high.
std::int64_t count_within(std::int64_t low, std::int64_t high, std::int64_t anchor,
                          std::int64_t length) {
  const auto below = [&](std::int64_t limit) {  // the k with anchor + k * length < limit, from -inf
    const std::int64_t apart = limit - anchor;
    return apart / length + (apart % length > 0 ? 1 : 0);
  };
  return std::max<std::int64_t>(0, below(high) - below(low));
}

}  // namespace

RainPeriods::RainPeriods(Totalling totalling, std::string file, Take take)
    : totalling_(std::move(totalling)),
      file_(std::move(file)),
      take_(std::move(take)),
      errors_(totalling_.errors) {}

void RainPeriods::add(const RainStep& step) {
  const IsoTime time = time_of_step(step.time, totalling_.every, file_, step.line, step.written);
  if (!begun_.empty() && step.time != text_before_ && time.precision == before_.precision &&
      time.ahead_of_utc == before_.ahead_of_utc && order_of_moments(time, before_) == 0) {
    throw Error({file_, step.line,
                 "time " + quoted(step.time, 80) + " is that of the step before, written again",
                 ""});
  }
  require_step_of_rates(time, step);
  before_ = time;
  text_before_ = step.time;
  intervals_.note({time, IsoTimeFault::none});
  ends_days_ = ends_days_ || (time.hour == 24 && totalling_.stamp == Stamp::begin);
  const IsoTime within = within_step(time);
  if (!open_ || number_of(within) != held_.back().number) {
    const bool ends = open_;
    if (ends) end();
    begin(within, step);
    if (ends && totalling_.as_they_end) hand_on_ended();
  }
  ++held_.back().steps;
  held_.back().last_ahead = time.ahead_of_utc.value_or(0);
  errors_.add(step.basins,
              totalling_.depths ? totalling_.depths->of(1, within, totalling_.stamp) : 1);
  for (std::size_t b = 0; b < sums_.size(); ++b) {
    const double rainfall = step.basins[b].rainfall;
    Sum& sum = sums_[b];
    if (std::isnan(rainfall)) {
      ++sum.missing;
    } else {
      ++sum.values;
      const auto& depths = totalling_.depths;
      sum.rainfall.add(depths ? depths->of(rainfall, within, totalling_.stamp) : rainfall);
    }
  }
}

/// Refuses a time that shows another step of rates than that by which totals are told already.
void RainPeriods::require_step_of_rates(const IsoTime& time, const RainStep& step) const {
  if (!step_of_rates_) return;
  if ((moment_seconds(time) - moment_seconds(before_)) % step_of_rates_->seconds == 0) return;
  throw rates_without_step(file_, totalling_.rates->unit,
                           "time " + quoted(step.time, 80) + " in line " +
                               std::to_string(step.line) + " lies no whole steps of " +
                               thiessen::text_of(*step_of_rates_) +
                               " from the one before, which the times above tell");
}

/// What a rate of 1 counts for, by the step that the times so far tell.
double RainPeriods::depth_of_rate() {
  if (!totalling_.rates) return 1;
  if (!step_of_rates_) step_of_rates_ = intervals_.step();
  const auto fail = [&](const std::string& why) {
    return rates_without_step(file_, totalling_.rates->unit, why);
  };
  if (intervals_.times() < 2) throw fail("one time tells none");
  if (!step_of_rates_) throw fail("the times have no regular step");
  if (step_of_rates_->months > 0)
    throw fail("what is read only once does not tell that of months in time");
  return static_cast<double>(step_of_rates_->seconds) /
         static_cast<double>(totalling_.rates->rate.seconds);
}

void RainPeriods::begin(const IsoTime& time, const RainStep& step) {
  const std::int64_t number = number_of(time);
  if (!begun_.insert(number).second) {
    throw Error({file_, step.line,
                 "time " + quoted(step.time, 80) + " comes back to " +
                     date_text(time, totalling_.every) + " after another period has begun",
                 "sort the file by time"});
  }
  held_.push_back({number, time, 0, 0});
  sums_.assign(step.basins.size(), Sum{});
  errors_.begin(step.basins.size());
  open_ = true;
}

void RainPeriods::end() {
  taken_.clear();
  const double depth = depth_of_rate();
  for (std::size_t b = 0; b < sums_.size(); ++b) {
    const Sum& sum = sums_[b];
    taken_.push_back({sum.values > 0 ? sum.rainfall.value() * depth : no_value, sum.missing,
                      sum.values > 0 ? errors_.of(b) * depth : no_value});
  }
  if (!totalling_.as_they_end) totals_.add(taken_);
  open_ = false;
}

/// Hands on the period before the one that has begun.
void RainPeriods::hand_on_ended() {
  const Held ended = held_.front();
  const Held& begun = held_.back();
  const std::optional<StepLength> step = intervals_.step();
  ascends_ = ascends_ && ended.number < begun.number;
  descends_ = descends_ && ended.number > begun.number;
  if (step) lacking_step_ = step;
  const Extent extent = extent_of(ended, step, ascends_);
  hand_on(ended.number, extent.lacking, extent.all);
  if (step && (ascends_ || descends_)) hand_on_absent(ended, begun, *step);
  held_.erase(held_.begin());
}

/// A moment of the step: its time, or where that ends the step the second before it.
IsoTime RainPeriods::within_step(const IsoTime& time) const {
  if (totalling_.stamp == Stamp::begin || time.precision != TimePrecision::instant) return time;
  IsoTime within = parse_iso_time(time_text(clock_seconds(time) - 1, TimePrecision::instant)).time;
  within.ahead_of_utc = time.ahead_of_utc;
  return within;
}

std::int64_t RainPeriods::number_of(const IsoTime& time) const {
  if (totalling_.every == TimePrecision::year) return time.year;
  if (totalling_.every == TimePrecision::month) return month_number(time);
  IsoTime day = time;
  day.hour = day.minute = day.second = 0;
  return clock_seconds(day) / day_seconds -
         (clock_seconds(day) < 0 && clock_seconds(day) % day_seconds != 0 ? 1 : 0);
}

std::string RainPeriods::text_of(std::int64_t number) const {
  if (totalling_.every == TimePrecision::day)
    return time_text(number * day_seconds, TimePrecision::day);
  const bool years = totalling_.every == TimePrecision::year;
  return date_text(month_of(years ? 12 * number : number), totalling_.every);
}

/// The first second of a period, by the clock.
std::int64_t RainPeriods::begin_of(std::int64_t number) const {
  if (totalling_.every == TimePrecision::day) return number * day_seconds;
  return clock_seconds(month_of(totalling_.every == TimePrecision::year ? 12 * number : number));
}

/// How many steps of months a period has.
std::int64_t RainPeriods::months_within(std::int64_t number, const StepLength& step,
                                        const IsoTime& in_line_with) const {
  const bool years = totalling_.every == TimePrecision::year;
  std::int64_t count = 0;
  for (std::int64_t month = years ? 12 * number : number;
       month < (years ? 12 * (number + 1) : number + 1); ++month) {
    IsoTime time = in_line_with;
    time.year = static_cast<int>(month / 12);
    time.month = static_cast<int>(month % 12) + 1;
    // A day that the month lacks is its last, as 31 January is followed by 28 February.
    time.day = std::min(in_line_with.day, days_in_month(time));
    const bool in_line = (month - month_number(in_line_with)) % step.months == 0;
    count += in_line && totalling_.range.holds(time) ? 1 : 0;
  }
  return count;
}

/// How many steps a period has where none lacks: those in line with a step of it. `growth` is by
/// how many minutes the zone's offset grows in the period, which shortens it: summer time begins.
std::int64_t RainPeriods::expected(std::int64_t number, const StepLength& step,
                                   const IsoTime& in_line_with, int growth) const {
  if (step.months > 0) {
    return totalling_.every == TimePrecision::day ? 0 : months_within(number, step, in_line_with);
  }
  std::int64_t low = begin_of(number);
  std::int64_t high = begin_of(number + 1);
  const auto clock = [&](const IsoTime& limit) {
    const bool zones = limit.ahead_of_utc && in_line_with.ahead_of_utc;
    return clock_seconds(limit) +
           (zones ? std::int64_t{60} * (*in_line_with.ahead_of_utc - *limit.ahead_of_utc) : 0);
  };
  // The range is of times as they are written, a second behind what is counted where they end
  // steps.
  const std::int64_t behind = totalling_.stamp == Stamp::end ? 1 : 0;
  if (const auto& from = totalling_.range.from) low = std::max(low, clock(*from) - behind);
  if (const auto& to = totalling_.range.to) {
    IsoTime end = *to;
    if (to->precision == TimePrecision::year) end.month = 12;
    if (to->precision <= TimePrecision::month) {
      end.day = days_in_month(end);
    }
    high = std::min(
        high, clock(end) - behind + (to->precision == TimePrecision::instant ? 1 : day_seconds));
  }
  return count_within(low, high - std::int64_t{60} * growth, clock_seconds(in_line_with),
                      step.seconds);
}

void RainPeriods::hand_on(std::int64_t number, std::size_t lacking, std::size_t expected) {
  RainPeriod period{text_of(number), taken_};
  for (BasinTotal& total : period.basins) {
    total.missing += lacking;
    if (total.missing > totalling_.allowed_missing)
      total.rainfall = total.standard_error = no_value;
  }
  if (lacking > 0 && ++lacking_periods_ == 1) {
    first_lacking_ = period.time + ", which lacks " + std::to_string(lacking) + " of " +
                     std::to_string(expected);
  }
  take_(period);
}

/// Hands on the periods between two that follow each other in the file and in time, for they have
/// no step.
void RainPeriods::hand_on_absent(const Held& before, const Held& after, const StepLength& step) {
  const std::int64_t way = before.number < after.number ? 1 : -1;
  if ((after.number - before.number) * way > most_absent) {
    throw Error({file_, 0,
                 "no step lies between " + text_of(std::min(before.number, after.number)) +
                     " and " + text_of(std::max(before.number, after.number)),
                 "is one of them mistyped?"});
  }
  std::fill(taken_.begin(), taken_.end(), BasinTotal{no_value, 0});
  for (std::int64_t number = before.number + way; number != after.number; number += way) {
    const auto lacking = static_cast<std::size_t>(expected(number, step, before.first, 0));
    if (lacking > 0) hand_on(number, lacking, lacking);
  }
}

RainPeriods::Extent RainPeriods::extent_of(const Held& held, const std::optional<StepLength>& step,
                                           bool ascends) const {
  if (!step) return {};
  const int growth = ascends ? held.last_ahead - held.first.ahead_of_utc.value_or(0) : 0;
  const std::int64_t all = expected(held.number, *step, held.first, growth);
  const auto lacking = std::max<std::int64_t>(0, all - static_cast<std::int64_t>(held.steps));
  return {static_cast<std::size_t>(all), static_cast<std::size_t>(lacking)};
}

/// Whether the last period is not handed on, for its end may be still to come, and says so.
bool RainPeriods::is_left_out(const Held& last, const std::optional<StepLength>& step,
                              const Extent& extent, Warnings& warnings) const {
  if (!totalling_.whole_alone || (step && extent.lacking == 0)) return false;
  const std::string lacks = step ? ": it lacks " + std::to_string(extent.lacking) + " of " +
                                       std::to_string(extent.all) + " steps"
                                 : ", for the times have no regular step";
  warnings.add_notice(
      {file_, 0,
       "the last period, " + text_of(last.number) + ", is left out, as it may not be over" + lacks,
       ""});
  return true;
}

void RainPeriods::finish(Warnings& warnings) {
  if (open_) end();
  const std::optional<StepLength> step = intervals_.step();
  if (step) lacking_step_ = step;
  const auto number = [](const Held& held) { return held.number; };
  const bool ascends = ascends_ && std::ranges::is_sorted(held_, {}, number);
  const bool descends = descends_ && std::ranges::is_sorted(held_, std::ranges::greater(), number);
  taken_.resize(sums_.size());
  for (std::size_t i = 0; i < held_.size(); ++i) {
    const Held& held = held_[i];
    if (!totalling_.as_they_end) totals_.take(taken_);
    const Extent extent = extent_of(held, step, ascends);
    const bool is_last = ascends && i + 1 == held_.size();
    if (is_last && is_left_out(held, step, extent, warnings)) break;
    hand_on(held.number, extent.lacking, extent.all);
    if (step && (ascends || descends) && i + 1 < held_.size())
      hand_on_absent(held, held_[i + 1], *step);
  }
  warn(warnings);
}

void RainPeriods::warn(Warnings& warnings) const {
  if (ends_days_) {
    warnings.add_notice({file_, 0,
                         "24:00 counts in the day that it ends, and any other time begins its step",
                         setting("stamp", "end") + " says that times end their steps"});
  }
  if (step_of_rates_) {
    warnings.add_notice(
        {file_, 0, "rates counted times their step of " + thiessen::text_of(*step_of_rates_), ""});
  }
  if (intervals_.times() > 0 && !lacking_step_) {
    const char* why =
        intervals_.times() == 1 ? "there is one time step" : "the times have no regular step";
    warnings.add({file_, 0,
                  why + std::string(": steps that the file lacks inside a period are not counted "
                                    "as missing"),
                  ""});
  }
  if (lacking_periods_ == 0) return;
  const bool one = lacking_periods_ == 1;
  warnings.add({file_, 0,
                (one ? "a period lacks steps of "
                     : std::to_string(lacking_periods_) + " periods lack steps of ") +
                    thiessen::text_of(*lacking_step_) + (one ? ": " : ", the first is ") +
                    first_lacking_ + "; they count as missing",
                setting("allow_missing") + " says how many a total may lack"});
}

}  // namespace thiessen
