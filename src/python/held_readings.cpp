#include "python/held_readings.h"

#include <cmath>
#include <cstdint>

#include "base/error.h"
#include "base/utf8.h"

namespace thiessen::python {
namespace {

/// A time by the calendar. The formats that files of readings may have are of no help here.
WrittenTime written(const std::string& time) {
  WrittenTime said;
  said.parsed = parse_iso_time(time);
  if (said.parsed) return said;
  said.fault = said.parsed.fault == IsoTimeFault::value ? " does not exist"
                                                        : " is not written as ISO 8601 wants it";
  said.hint = std::string("wanted: ") + iso_time_forms + ", or an index of timestamps";
  return said;
}

}  // namespace

void check_readings(const Matrix& readings, const std::vector<std::string>& ids) {
  if (readings.stations != ids.size()) {
    throw Error({"", 0,
                 std::to_string(ids.size()) + " stations were given, and the readings have " +
                     std::to_string(readings.stations) + " columns: one for each is needed",
                 ""});
  }
  Complaints complaints;
  for (std::size_t step = 0; step < readings.steps; ++step) {
    const std::span<const double> row = readings[step];
    for (std::size_t s = 0; s < row.size(); ++s) {
      if (!(row[s] < 0) && !std::isinf(row[s])) continue;
      complaints.add({"", 0,
                      "the reading of station " + quoted(ids[s], 80) + " in row " +
                          std::to_string(step) + " is " +
                          (std::isinf(row[s]) ? "not finite" : "negative"),
                      "a gauge that does not report reads NaN"});
    }
  }
  complaints.throw_if_any();
}

ReportingStations heard_in(const Matrix& readings) {
  ReportingStations heard(readings.stations, false);
  for (std::uint32_t s = 0; s < readings.stations; ++s) {
    for (std::size_t step = 0; step < readings.steps; ++step) {
      if (std::isnan(readings[step][s])) continue;
      heard.set(StationIndex{s}, true);
      break;
    }
  }
  return heard;
}

bool DatedRows::next(TimeStep& step) {
  if (next_ == rows_.size()) return false;
  step.time = times_.empty() ? std::to_string(next_) : times_[next_];
  step.readings = rows_.row(next_, buffer_);
  step.line = ++next_;
  step.written = written(step.time);
  return true;
}

}  // namespace thiessen::python
