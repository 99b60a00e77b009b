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
  double rainfall;      ///< sum of the steps' values; NaN where it cannot be had
  std::size_t missing;  ///< steps without a value
};

/// A year, month or day of a series of areal rainfall.
struct RainPeriod {
  std::string time;  ///< 2013, 2013-08, 2013-08-01
  std::vector<BasinTotal> basins;
};

/// What rainfall is summed over.
struct Totalling {
  TimePrecision every = TimePrecision::month;  ///< not instant
  std::size_t allowed_missing = 0;  ///< steps of a period without a value that leave it its total
};

/// Sums a series of areal rainfall over calendar periods, those of the times as they are written
/// (24:00 belongs to the day that it ends, zones play no part).
///
/// The steps of a period follow each other; the periods come in any order, each once. A total is of
/// the steps that have a value, and there is none where no step has, or more than allowed have
/// none. Steps that the series lacks are not counted, and a period without any is not handed on.
/// Sums are LongSums: the order of the steps does not show. Memory: one period, and some 40 bytes
/// for each that has ended.
class RainPeriods {
 public:
  using Take = std::function<void(const RainPeriod&)>;

  /// `take` gets each period once it has ended; `file` is for messages.
  RainPeriods(Totalling totalling, std::string file, Take take);

  /// Throws Error where the step's time is not ISO 8601 or does not say its period, is that of the
  /// step before written otherwise, and where its period has ended before.
  void add(const RainStep& step);
  /// Hands on the last period, and warns where periods have no step on their first or last day (or
  /// month, where steps are months): what is missing there is not counted.
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
  IsoTime first_;  ///< of the period's steps, by date
  IsoTime last_;
  IsoTime before_;  ///< of the step before
  std::string text_before_;
  std::vector<Sum> sums_;
  std::unordered_set<int> begun_;
  std::size_t partial_ = 0;
  std::string first_partial_;
  bool open_ = false;
};

}  // namespace thiessen
