#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "rainfall/network/network.h"
#include "rainfall/series/readings.h"
#include "rainfall/series/step_intervals.h"
#include "readings/steps/monthly_readings.h"
#include "readings/steps/spaced_readings.h"

namespace thiessen {

/// Watches the steps of a file for gauges that report in longer steps than the others, as where
/// daily totals stand in a table of hours: no weights make a mean of such readings.
///
/// A gauge is one of these if its times are written without a clock and others' with one, or
/// without a day and others' with one; or if it has at least three readings, all of them multiples
/// of k of the file's steps apart, k at least 2, or whole months of the calendar in a file of
/// shorter steps, and fills more than half of the steps of that length between its first and its
/// last; unless gauges that are as often silent as the others would come to that by chance in more
/// than one of a hundred files. Cost: a few operations a reading. Memory: 104 bytes a station.
class MixedSteps {
 public:
  explicit MixedSteps(std::size_t stations) : gauges_(stations) {}

  /// Takes note of a step, in the order of the file. `readings` has one entry a station, NaN where
  /// it is silent.
  void note(std::string_view time, std::size_t line, std::span<const double> readings) {
    note(calendar_time(time, {}), time, line, readings);
  }
  /// The same of a time that says `parsed`.
  void note(const ParsedTime& parsed, std::string_view time, std::size_t line,
            std::span<const double> readings);

  /// The file's intervals as far as they were noted.
  const StepIntervals& intervals() const { return intervals_; }
  /// What is wrong with the steps: times with a zone beside times without one, or gauges of other
  /// steps than the others; nothing where nothing is. `file` is for the message.
  std::optional<Message> fault(const std::string& file, std::span<const Station> stations) const;

 private:
  struct Gauge {
    SpacedReadings readings;  ///< in months or in seconds
    MonthlyReadings monthly;
    TimePrecision coarsest = TimePrecision::instant;  ///< of the times at which it reports
  };
  /// A time as it is written, and where.
  struct Written {
    std::string time;
    std::size_t line = 0;
  };

  void note_form(const IsoTime& time, std::string_view text, std::size_t line,
                 std::span<const double> readings);
  void note_readings(std::int64_t at, const CalendarPlace& calendar,
                     std::span<const double> readings);
  std::optional<Message> mixed_forms(const std::string& file,
                                     std::span<const Station> stations) const;
  template <typename IsCoarse>
  std::vector<StationIndex> gauges_that(const IsCoarse& is_coarse) const;
  double share_silent(const std::vector<StationIndex>& but_for) const;
  template <typename InSteps>
  void leave_chance_out(std::vector<StationIndex>& coarse, const InSteps& in_steps) const;
  void count_in_seconds();
  std::optional<Message> mixed_zones(const std::string& file) const;
  Message mixed(const std::string& file, std::span<const Station> stations,
                const std::vector<StationIndex>& coarse, const std::string& how) const;

  StepIntervals intervals_;
  std::vector<Gauge> gauges_;
  std::optional<IsoTime> first_time_;
  bool in_months_ = true;  ///< positions are months, as long as all times stand alike in theirs
  std::optional<Written> zoned_, zoneless_;
  std::array<std::optional<Written>, 4> written_;  ///< by precision, the first time of each
};

}  // namespace thiessen
