#include "rainfall/series/dated_readings.h"

#include <utility>

#include "base/interrupt.h"
#include "base/utf8.h"

namespace thiessen {
namespace {

constexpr std::size_t longest_time = 80;

const char* name_of(TimePrecision precision) {
  if (precision == TimePrecision::instant) return "hour";
  return precision == TimePrecision::day ? "day" : "month";
}

}  // namespace

ParsedTime calendar_time(std::string_view time, const std::optional<WrittenTime>& written) {
  return written ? written->parsed : parse_iso_time(trimmed(time));
}

IsoTime time_of_step(std::string_view text, TimePrecision least, const std::string& file,
                     std::size_t line, const std::optional<WrittenTime>& written) {
  const ParsedTime parsed = calendar_time(text, written);
  const std::string time = "time " + quoted(text, longest_time);
  if (written && !written->fault.empty())
    throw Error({file, line, time + written->fault, written->hint});
  const Wording wanted = std::string("wanted: ") + iso_time_forms + "; " + setting("time_format") +
                         " says how else, such as '%d/%m/%Y %H:%M'";
  if (parsed.fault == IsoTimeFault::form)
    throw Error({file, line, time + " is not written as ISO 8601 wants it", wanted});
  if (parsed.fault == IsoTimeFault::value)
    throw Error({file, line, time + " does not exist", wanted});
  if (parsed.time.precision < least && least == TimePrecision::instant) {
    throw Error({file, line,
                 time + " does not say the hour, which hours and the start of days want",
                 setting("every", "day") +
                     " sums dates, each of which is a day whenever it begins: "
                     "leave " +
                     setting("day_start") + " out"});
  }
  if (parsed.time.precision < least) {
    throw Error({file, line, time + " does not say the " + name_of(least),
                 setting("every") + " takes periods that are no shorter than the steps"});
  }
  return parsed.time;
}

DatedReadings::DatedReadings(std::unique_ptr<Readings> all, std::string file, StepTimes wanted,
                             Warnings& warnings)
    : all_(std::move(all)), file_(std::move(file)), wanted_(wanted), warnings_(warnings) {}

bool DatedReadings::next(TimeStep& step) {
  if (std::exchange(has_ahead_, false)) {
    step = std::move(ahead_);
    return true;
  }
  while (!gives_up() && read(step)) {
    if (takes(step)) return true;
  }
  complaints_.throw_if_any();
  if (!any_ && !first_.empty()) warn_of_none();
  return false;
}

bool DatedReadings::is_waiting(std::chrono::milliseconds patience) {
  while (!has_ahead_ && complaints_.empty()) {
    if (all_->is_waiting(patience)) return true;
    if (!read(ahead_)) return false;  // the end, which comes again
    has_ahead_ = takes(ahead_);
  }
  return false;
}

/// Whether what is wrong in a pipe is to be told before its end, as nothing comes for a while.
bool DatedReadings::gives_up() {
  return !complaints_.empty() && all_->is_waiting(patience_.left());
}

bool DatedReadings::takes(const TimeStep& step) {
  throw_if_interrupted();
  if (counts(step) && complaints_.empty()) return any_ = true;
  if (any_) return false;
  if (first_.empty()) first_ = step.time;
  last_ = step.time;
  return false;
}

bool DatedReadings::read(TimeStep& step) {
  try {
    return all_->next(step);
  } catch (const Error& error) {
    complaints_.add(error);
    return false;
  }
}

bool DatedReadings::counts(const TimeStep& step) {
  try {
    return wanted_.range.holds(
        time_of_step(step.time, wanted_.least, file_, step.line, step.written));
  } catch (const Error& error) {
    // How times are written is told once: twenty lines that say the same hide what differs.
    const bool form = calendar_time(step.time, step.written).fault == IsoTimeFault::form;
    if (!form || !std::exchange(told_form_, true)) complaints_.add(error);
    return false;
  }
}

void DatedReadings::warn_of_none() {
  warnings_.add({file_, 0,
                 "no time step is in the range: the first is " + quoted(first_, longest_time) +
                     ", the last " + quoted(last_, longest_time),
                 ""});
  first_.clear();  // so that the warning comes only once
}

}  // namespace thiessen
