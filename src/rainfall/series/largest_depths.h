#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/iso_time.h"
#include "geometry/long_sum.h"
#include "rainfall/series/rain_series.h"
#include "rainfall/series/step_intervals.h"
#include "rainfall/series/step_length.h"

namespace thiessen {

/// The most rain that fell within a length of time, such as 24 hours.
struct LargestDepth {
  double depth = 0;
  std::string time;  ///< of the first of its steps, as the file writes it
};

/// Looks for the largest depths of a series of areal rainfall in lengths of time, basin by basin,
/// wherever they begin: each is the sum over consecutive steps, and one of which a step lacks, or
/// has no value, does not count. Of equal ones the earliest is told.
///
/// Which step the file has is known only in the end (StepIntervals), so that the first few
/// intervals that may be it are each followed. Sums are LongSums, which a step is added to and
/// later taken from. Memory: the steps of the longest length, and their times.
class LargestDepths {
 public:
  /// `lengths` in seconds. `file` is for messages.
  LargestDepths(std::vector<std::int64_t> lengths, std::size_t basins, std::string file);

  /// Adds a step. Throws Error where its time is not of the calendar, or out of order.
  void add(const RainStep& step);

  /// By length and then by basin; nothing where no such time is known from end to end. Values that
  /// are rates count times the step: `rate` is the time in which they fall. Throws Error where the
  /// file has no step, where a length is not whole steps, and of rates of months.
  std::vector<std::vector<std::optional<LargestDepth>>> result(
      const std::optional<StepLength>& rate) const;

 private:
  struct Step {
    std::int64_t moment = 0;
    std::string time;
    std::vector<double> values;
  };
  /// The sums over one length of time up to the latest step, and the largest so far.
  struct Window {
    std::size_t steps = 0;
    std::vector<LongSum> sums;
    std::vector<std::size_t> missing;
    std::vector<std::optional<LargestDepth>> largest;
  };
  /// The steps that follow each other at one interval.
  struct Pace {
    std::size_t last = 0;         ///< the number of its latest step
    std::size_t run = 0;          ///< how many steps there are without a break
    std::vector<Window> windows;  ///< by length; without steps where that is not whole ones
  };

  std::int64_t way_from_before(const RainStep& step, const IsoTime& time);
  void go_on(Pace& pace);
  void take(Pace& pace, std::size_t number);
  Window window_of(std::int64_t length, std::int64_t interval) const;
  const Step& step(std::size_t number) const { return steps_[number - first_]; }
  void note(std::optional<LargestDepth>& largest, double depth, const std::string& time) const;

  std::vector<std::int64_t> lengths_;
  std::size_t basins_;
  std::string file_;
  StepIntervals intervals_;
  std::map<std::int64_t, Pace> paces_;  ///< by interval
  std::vector<Window> single_;          ///< by length: of steps as long as that
  std::deque<Step> steps_;
  std::size_t first_ = 0;  ///< the number of the first of them
  std::int64_t way_ = 0;
};

}  // namespace thiessen
