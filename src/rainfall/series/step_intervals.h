#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "base/iso_time.h"
#include "rainfall/series/step_length.h"

namespace thiessen {

/// The intervals between the times of a file, and the file's step that they tell.
///
/// The step is the longest interval of which at least nine in ten of all intervals are multiples,
/// by the calendar (months, years) where that holds, else by the clock. There is none where no
/// interval is so, where a time is a label and no time of ISO 8601, and where there is one time
/// only. Memory: some 60 bytes for each different interval; beyond 1,000 of them there is no step.
class StepIntervals {
 public:
  /// Takes note of the next time of the file, in the file's order. Cost: the logarithm of the
  /// number of different intervals.
  void note(const ParsedTime& time);

  /// The file's step. Cost: the square of the number of different intervals.
  std::optional<StepLength> step() const;
  /// Whether a time that was noted is a label.
  bool has_labels() const { return labels_; }
  std::size_t times() const { return times_; }

  /// The steps that the file lacks between its first and its last.
  struct Lacking {
    std::size_t steps = 0;
    std::string first;  ///< the time of the first of them
    std::string last;
  };
  /// What lacks of a file whose step is given; nothing where its times neither ascend nor descend.
  std::optional<Lacking> lacking(const StepLength& step) const;

 private:
  struct Interval {
    std::size_t count = 0;
    std::int64_t first = 0;  ///< the earlier time of the first such interval: seconds, or a month
    std::int64_t last = 0;   ///< the later time of the last one
  };
  using Intervals = std::map<std::int64_t, Interval>;  // by length

  static void enter(Intervals& intervals, std::int64_t from, std::int64_t to);
  std::optional<std::int64_t> common(const Intervals& intervals) const;

  std::optional<IsoTime> before_;
  Intervals months_;
  Intervals seconds_;
  std::size_t times_ = 0;
  bool labels_ = false;
  bool too_many_ = false;
  bool ascends_ = false;
  bool descends_ = false;
};

}  // namespace thiessen
