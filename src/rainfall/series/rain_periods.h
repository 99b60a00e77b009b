#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <unordered_set>
#include <vector>

#include "base/error.h"
#include "base/iso_time.h"
#include "geometry/long_sum.h"
#include "rainfall/series/rain_series.h"

namespace thiessen {

/// The areal rainfall of a basin over a period.
struct BasinTotal {
  double rainfall;      ///< sum of the steps' values; NaN where there is none
  std::size_t missing;  ///< steps without a value
};

/// The totals of one year, month or day of a series of areal rainfall.
struct RainPeriod {
  std::string time;  ///< such as 2013, 2013-08 or 2013-08-01
  std::vector<BasinTotal> basins;
};

/// The periods over which rainfall is summed, and how many values a total may lack.
struct Totalling {
  TimePrecision every = TimePrecision::month;  ///< not instant
  std::size_t allowed_missing = 0;  ///< steps that may lack a value in a period with a total
};

/// Sums a series of areal rainfall over calendar periods. The period of a step is the one that its
/// time says as it is written: 24:00 belongs to the day that it ends, and time zones play no part.
///
/// The steps of a period follow each other; the periods come in any order, each once. A total is
/// the sum of the steps that have a value. There is no total where no step has a value, or where
/// more steps than allowed lack one. Steps that the series does not have are not counted, and a
/// period without any step is not handed on. Sums are LongSums, so the order of the steps does not
/// matter. Memory: one period, and some 40 bytes for each that has ended.
class RainPeriods {
 public:
  using Take = std::function<void(const RainPeriod&)>;

  /// `take` gets each period once it has ended. `file` is for messages.
  RainPeriods(Totalling totalling, std::string file, Take take);

  /// Adds a step. Throws Error if its time is not ISO 8601 or does not say its period, if its time
  /// is that of the step before written differently, and if its period has ended before.
  void add(const RainStep& step);
  /// Hands on the last period. Warns if periods have no step on their first or last day (or month,
  /// where steps are months), for what is missing there is not counted.
  void finish(Warnings& warnings);

 private:
  struct Sum {
    LongSum rainfall;
    std::size_t values = 0;
    std::size_t missing = 0;
  };

  void begin(const IsoTime& time, const RainStep& step);
  void end();
  bool is_partial() const;
  BasinTotal total_of(const Sum& sum) const;

  Totalling totalling_;
  std::string file_;
  Take take_;
  IsoTime first_;   ///< earliest time of the period's steps, by date
  IsoTime last_;    ///< latest time of the period's steps, by date
  IsoTime before_;  ///< time of the step before
  std::string text_before_;
  std::vector<Sum> sums_;
  std::unordered_set<int> begun_;
  std::size_t partial_ = 0;
  std::string first_partial_;
  bool open_ = false;
};

}  // namespace thiessen
