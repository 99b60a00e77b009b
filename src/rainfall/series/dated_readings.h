#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/patience.h"
#include "rainfall/series/readings.h"
#include "rainfall/series/stamp.h"
#include "rainfall/series/time_range.h"

namespace thiessen {

/// What the times of a table have to be, and which of them count.
struct StepTimes {
  TimeRange range;
  TimePrecision least = TimePrecision::year;  ///< least precision of a time
};

/// The time of a step by the calendar: what is `written`, or the text as ISO 8601. Throws Error,
/// with file and line (0 where it is not known), if that is not known or is less precise than
/// `least`.
IsoTime time_of_step(std::string_view text, TimePrecision least, const std::string& file,
                     std::size_t line, const std::optional<WrittenTime>& written = {});

/// Readings that pass on only the steps of other readings whose times are in a range.
///
/// Every step is read. Steps whose time is wrong are reported at the end of the file, together with
/// what else is wrong in it; none of the steps that follow the first of them is passed on. A file
/// that has steps but none in the range gets a warning.
class DatedReadings : public Readings {
 public:
  /// `file` is for messages. `warnings` must outlive this object.
  DatedReadings(std::unique_ptr<Readings> all, std::string file, StepTimes wanted,
                Warnings& warnings);

  bool next(TimeStep& step) override;
  bool is_waiting(std::chrono::milliseconds patience) override;
  std::string unit() const override { return all_->unit(); }
  std::optional<Stamp> stamp() const override { return all_->stamp(); }
  double share_read() const override { return all_->share_read(); }

 private:
  bool takes(const TimeStep& step);
  bool gives_up();
  bool read(TimeStep& step);
  bool counts(const TimeStep& step);
  void warn_of_none();

  std::unique_ptr<Readings> all_;
  std::string file_;
  StepTimes wanted_;
  Warnings& warnings_;
  Complaints complaints_;
  Patience patience_;  ///< with what may follow a step with a fault, in a pipe
  TimeStep ahead_;     ///< the next step, where it was read to see whether it has come
  bool has_ahead_ = false;
  bool told_form_ = false;  ///< whether it was said that times are written in no known way
  bool any_ = false;        ///< whether any step is in the range
  std::string first_;       ///< first time of all
  std::string last_;        ///< last time before the first in the range
};

}  // namespace thiessen
