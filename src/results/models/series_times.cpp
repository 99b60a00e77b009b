#include "results/models/series_times.h"

#include <stdexcept>

#include "base/utf8.h"

namespace thiessen {

IsoTime calendar_time_for(const std::string& name, std::string_view time,
                          const std::optional<WrittenTime>& written, const std::string& file,
                          std::size_t line) {
  const ParsedTime parsed = calendar_time(time, written);
  if (parsed) return parsed.time;
  if (written && !written->fault.empty())
    throw Error({file, line, "the time " + quoted(time, 80) + written->fault, written->hint});
  throw Error(
      {file, line,
       "the time " + quoted(time, 80) + " is none of the calendar, and " + name + " wants one",
       setting("time_format") + " says how times are written; a CSV takes any"});
}

void SeriesTimes::note(const IsoTime& time) {
  if (count_++ == 0) first_ = time;
  if (time.ahead_of_utc.has_value() != first_.ahead_of_utc.has_value()) {
    throw Error({file_, 0,
                 "some times have a zone and others have none, and " + format_ + " counts from one",
                 "a CSV takes any times"});
  }
  intervals_.note({time, IsoTimeFault::none});
}

std::int64_t SeriesTimes::seconds_of(const IsoTime& time) const {
  return moment_seconds(time) + std::int64_t{60} * first_.ahead_of_utc.value_or(0);
}

std::optional<StepLength> SeriesTimes::step() const {
  if (known_step_) return known_step_;
  if (count_ != 1) return intervals_.step();
  switch (first_.precision) {
    case TimePrecision::year:
      return StepLength{12, 0};
    case TimePrecision::month:
      return StepLength{1, 0};
    case TimePrecision::day:
      return StepLength{0, seconds_of_day};
    case TimePrecision::instant:
      return std::nullopt;
  }
  throw std::logic_error("not a precision of times");
}

std::string zone_text(int minutes_ahead) {
  IsoTime time;
  time.precision = TimePrecision::instant;
  time.ahead_of_utc = minutes_ahead;
  return iso_text(time).substr(std::string_view("0000-01-01T00:00").size());
}

}  // namespace thiessen
