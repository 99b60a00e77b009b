#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "base/error.h"
#include "rainfall/series/readings.h"
#include "rainfall/series/time_range.h"

namespace thiessen {

/// What a table's times have to be, and which of them count.
struct StepTimes {
  TimeRange range;
  TimePrecision least = TimePrecision::year;  ///< that a time must say
};

/// The time of a step. Throws Error, with file and line (0 where it is not known), where it is not
/// ISO 8601, or is less precise than `least`.
IsoTime time_of_step(std::string_view text, TimePrecision least, const std::string& file,
                     std::size_t line);

/// Of other readings the steps whose times are in a range.
///
/// Every step is read, and those whose time is wrong are reported together with what else is wrong
/// in the file, at its end, in place of the steps that follow the first of them. Where the file has
/// steps but none is in the range, that is a warning.
class DatedReadings : public Readings {
 public:
  /// `file` is for messages; `warnings` must outlive this.
  DatedReadings(std::unique_ptr<Readings> all, std::string file, StepTimes wanted,
                Warnings& warnings);

  bool next(TimeStep& step) override;
  double share_read() const override { return all_->share_read(); }

 private:
  bool read(TimeStep& step);
  bool counts(const TimeStep& step);
  void warn_of_none();

  std::unique_ptr<Readings> all_;
  std::string file_;
  StepTimes wanted_;
  Warnings& warnings_;
  Complaints complaints_;
  bool any_ = false;   ///< in the range
  std::string first_;  ///< time of all
  std::string last_;   ///< time before the first in the range
};

}  // namespace thiessen
