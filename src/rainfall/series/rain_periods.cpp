#include "rainfall/series/rain_periods.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "base/calendar_days.h"
#include "base/error.h"
#include "base/utf8.h"
#include "rainfall/periods/periods_of_days.h"
#include "rainfall/series/dated_readings.h"

namespace thiessen {
namespace {

// Where more periods than these have no step, a time is more likely mistyped than a gauge silent.
constexpr std::int64_t most_absent = 100'000;
constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

constexpr std::int64_t hour_seconds = 3'600;

std::string clock_text(std::int64_t second_of_day) {
  const std::string text = time_text(second_of_day, TimePrecision::instant);
  return text.substr(text.find('T') + 1);
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
      calendar_(calendar_of(totalling_.every)),
      sums_(totalling_.depths, totalling_.stamp, totalling_.errors) {}

void RainPeriods::add(const RainStep& step) {
  const IsoTime time =
      time_of_step(step.time, totalling_.every.least_precision(), file_, step.line, step.written);
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
  ends_days_ = ends_days_ || (time.hour == 24 && totalling_.stamp == Stamp::begin &&
                              totalling_.every.unit != PeriodUnit::hours);
  const IsoTime within = within_step(time);
  if (!open_ || calendar_->number_of(within) != held_.back().number) {
    const bool ends = open_;
    if (ends) end();
    begin(within, step);
    if (ends && totalling_.as_they_end) hand_on_ended();
  }
  ++held_.back().steps;
  held_.back().last_ahead = time.ahead_of_utc.value_or(0);
  sums_.add(step.basins, within);
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
  const Held held{calendar_->number_of(time), time, 0, 0};
  if (!begun_.insert(held.number).second) {
    throw Error({file_, step.line,
                 "time " + quoted(step.time, 80) + " comes back to " + name_of(held) +
                     " after another period has begun",
                 "sort the file by time"});
  }
  held_.push_back(held);
  sums_.begin(step.basins.size());
  open_ = true;
}

void RainPeriods::end() {
  sums_.totals(depth_of_rate(), taken_);
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
  require_in_line(ended, step);
  const Extent extent = extent_of(ended, step, ascends_);
  hand_on(ended.number, ended.first, extent.lacking, extent.all);
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

std::string RainPeriods::name_of(const Held& held) const {
  return calendar_->name_of(held.number, held.first.ahead_of_utc);
}

/// How many steps of months a period has.
std::int64_t RainPeriods::months_within(std::int64_t number, const StepLength& step,
                                        const IsoTime& in_line_with) const {
  const std::int64_t last =
      month_of_day(floor_quotient(calendar_->begin_of(number + 1, 0) - 1, seconds_of_day));
  std::int64_t month = month_of_day(floor_quotient(calendar_->begin_of(number, 0), seconds_of_day));
  std::int64_t count = 0;
  for (; month <= last; ++month) {
    if ((month - month_number(in_line_with)) % step.months != 0) continue;
    IsoTime time = in_line_with;
    time.year = static_cast<int>(floor_quotient(month, 12));
    time.month = static_cast<int>(month - 12 * floor_quotient(month, 12)) + 1;
    // A day that the month lacks is its last, as 31 January is followed by 28 February.
    time.day = std::min(in_line_with.day, days_in_month(month));
    count += calendar_->number_of(time) == number && totalling_.range.holds(time) ? 1 : 0;
  }
  return count;
}

/// How many steps a period has where none lacks: those in line with a step of it. `growth` is by
/// how many minutes the zone's offset grows in the period, which shortens it: summer time begins.
std::int64_t RainPeriods::expected(std::int64_t number, const StepLength& step,
                                   const IsoTime& in_line_with, int growth) const {
  if (step.months > 0) {
    const bool holds_months = totalling_.every.unit >= PeriodUnit::month;
    return holds_months ? months_within(number, step, in_line_with) : 0;
  }
  const int ahead = in_line_with.ahead_of_utc.value_or(0);
  std::int64_t low = calendar_->begin_of(number, ahead);
  std::int64_t high = calendar_->begin_of(number + 1, ahead);
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
      end.day = days_in_month(month_number(end));
    }
    high = std::min(
        high, clock(end) - behind + (to->precision == TimePrecision::instant ? 1 : seconds_of_day));
  }
  return count_within(low, high - std::int64_t{60} * growth, clock_seconds(in_line_with),
                      step.seconds);
}

/// Whether no step lies on both sides of where a period begins, nor of where hours end.
bool RainPeriods::is_in_line(const Held& held, const StepLength& step) const {
  const int ahead = held.first.ahead_of_utc.value_or(0);
  const std::int64_t begin = calendar_->begin_of(held.number, ahead);
  const bool ends =
      totalling_.stamp == Stamp::end && held.first.precision == TimePrecision::instant;
  const std::int64_t since = clock_seconds(held.first) + (ends ? 1 : 0) - begin;
  if (totalling_.every.unit != PeriodUnit::hours)
    return since % (step.months > 0 ? seconds_of_day : step.seconds) == 0;
  const std::int64_t length = calendar_->begin_of(held.number + 1, ahead) - begin;
  return step.months == 0 && length % step.seconds == 0 && since % step.seconds == 0;
}

/// Refuses periods whose edges cut steps, where more than a tenth of them do so: a single time may
/// be odd.
void RainPeriods::require_in_line(const Held& held, const std::optional<StepLength>& step) {
  const Every& every = totalling_.every;
  if (!step || (every.unit != PeriodUnit::hours && !every.has_day_start)) return;
  ++looked_at_;
  if (is_in_line(held, *step)) return;
  if (10 * ++out_of_line_ > looked_at_) throw out_of_line(held, *step);
}

Error RainPeriods::out_of_line(const Held& held, const StepLength& step) const {
  const Every& every = totalling_.every;
  const std::string steps = "steps of " + thiessen::text_of(step);
  if (every.unit == PeriodUnit::hours) {
    const std::int64_t length = hour_seconds * every.hours;
    if (step.months > 0 || step.seconds > length || length % step.seconds != 0) {
      std::int64_t fits = step.months > 0 ? 0 : std::lcm(step.seconds, hour_seconds);
      if (fits > 0) fits *= (length + fits - 1) / fits;
      const std::string name =
          fits > 0 ? std::to_string(fits / hour_seconds) + "h" : std::string("month");
      return Error({file_, 0,
                    "periods of " + thiessen::text_of(StepLength{0, length}) +
                        " do not hold whole " + steps + ", which the file has",
                    setting("every", name) + " takes whole steps"});
    }
  }
  const std::int64_t begin = calendar_->begin_of(held.number, held.first.ahead_of_utc.value_or(0));
  const std::int64_t length = step.months > 0 ? seconds_of_day : step.seconds;
  const std::int64_t since =
      clock_seconds(held.first) - begin + (totalling_.stamp == Stamp::end ? 1 : 0);
  const std::int64_t next = begin + (since % length + length) % length;
  return Error(
      {file_, 0,
       name_of(held) + " begins at " + clock_text(begin) + ", within one of the " + steps +
           ", of which one begins at " + clock_text(next),
       setting("day_start", clock_text(next).substr(0, 5)) + " has days begin where a step does"});
}

void RainPeriods::hand_on(std::int64_t number, const IsoTime& in_line_with, std::size_t lacking,
                          std::size_t expected) {
  const std::optional<int> ahead = in_line_with.ahead_of_utc;
  RainPeriod period{calendar_->name_of(number, ahead), taken_};
  period.begin = parse_iso_time(
      time_text(calendar_->begin_of(number, ahead.value_or(0)), calendar_->precision()));
  if (calendar_->precision() == TimePrecision::instant) period.begin.time.ahead_of_utc = ahead;
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
                 "no step lies between " + name_of(way > 0 ? before : after) + " and " +
                     name_of(way > 0 ? after : before),
                 "is one of them mistyped?"});
  }
  std::fill(taken_.begin(), taken_.end(), BasinTotal{no_value, 0});
  for (std::int64_t number = before.number + way; number != after.number; number += way) {
    const auto lacking = static_cast<std::size_t>(expected(number, step, before.first, 0));
    if (lacking > 0) hand_on(number, before.first, lacking, lacking);
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
       "the last period, " + name_of(last) + ", is left out, as it may not be over" + lacks, ""});
  return true;
}

void RainPeriods::finish(Warnings& warnings) {
  if (open_) end();
  const std::optional<StepLength> step = intervals_.step();
  if (step) lacking_step_ = step;
  const auto number = [](const Held& held) { return held.number; };
  const bool ascends = ascends_ && std::ranges::is_sorted(held_, {}, number);
  const bool descends = descends_ && std::ranges::is_sorted(held_, std::ranges::greater(), number);
  taken_.resize(sums_.basins());
  for (std::size_t i = 0; i < held_.size(); ++i) {
    const Held& held = held_[i];
    if (!totalling_.as_they_end) totals_.take(taken_);
    require_in_line(held, step);
    const Extent extent = extent_of(held, step, ascends);
    const bool is_last = ascends && i + 1 == held_.size();
    if (is_last && is_left_out(held, step, extent, warnings)) break;
    hand_on(held.number, held.first, extent.lacking, extent.all);
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
