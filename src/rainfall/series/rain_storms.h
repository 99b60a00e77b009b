#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/iso_time.h"
#include "rainfall/series/period_sums.h"
#include "rainfall/series/rain_series.h"
#include "rainfall/series/rain_totals.h"
#include "rainfall/series/step_intervals.h"

namespace thiessen {

/// Sums a series of areal rainfall over storms, of the whole study: a storm begins with a step in
/// which any basin has rain, after a spell of `Every::dry` or longer in which none has. A step is
/// wet where a value is above 0. The spell lasts from the end of a wet step to the beginning of the
/// next. A storm is called by the time of its first wet step, as ISO 8601 writes it.
///
/// A step without a value, or that the file lacks, is not wet; but the rain of a storm may have
/// gone on in it. So it counts as missing in a basin if it lies in a storm, or so near before or
/// behind that rain in it would have been of the storm. What is unknown farther away is in no
/// storm, and is said.
///
/// Times have to ascend, or to descend. The step of the file is `Totalling::step`, else what the
/// times so far tell; where there is none a wet step has no length, and nothing lacks. Storms are
/// handed on as they end. Memory: the sums, and what is unknown within one dry spell.
class RainStorms : public RainTotals {
 public:
  RainStorms(Totalling totalling, std::string file, Take take);

  void add(const RainStep& step) override;
  void finish(Warnings& warnings) override;

 private:
  /// A step that is unknown in some basins.
  struct Unknown {
    std::int64_t moment;
    std::vector<bool> basins;  ///< whether it has no value; empty where the file lacks the step
    bool counts = false;       ///< whether it has been counted in a storm
  };
  /// The wet step that is first or last in time.
  struct Wet {
    std::int64_t moment = 0;
    IsoTime time;
  };

  void require_order(const IsoTime& time, const RainStep& step);
  void learn_step();
  void note_lacking(std::int64_t moment);
  void forget(std::int64_t moment);
  std::int64_t dry_before(std::int64_t moment, std::int64_t wet) const;
  void begin(std::size_t basins, std::int64_t moment);
  void wet(const IsoTime& time, std::int64_t moment);
  void lack(const Unknown& unknown);
  void end();
  double depth_of_rate() const;
  void warn_of_unknown(Warnings& warnings) const;

  Totalling totalling_;
  std::string file_;
  Take take_;
  StepIntervals intervals_;
  std::int64_t step_ = 0;  ///< seconds; 0 where it is not known
  PeriodSums sums_;
  std::optional<IsoTime> before_;
  int way_ = 0;  ///< 1 where times ascend, -1 where they descend
  bool open_ = false;
  bool lacks_begin_ = false;     ///< whether the open storm has had no wet step yet
  Wet begun_;                    ///< the wet step of the open storm that came first
  Wet last_wet_;                 ///< and the one that came last
  std::size_t lacking_ = 0;      ///< steps that the file lacks in the open storm
  std::deque<Unknown> unknown_;  ///< those that a storm that begins now may have rained in
  std::size_t unknown_between_ = 0;
  std::int64_t first_moment_ = 0;
  bool begins_with_file_ = false;  ///< whether the first storm may have begun before the file
  bool any_ = false;
  std::size_t lacking_storms_ = 0;
  std::string first_lacking_;
  std::vector<BasinTotal> taken_;
};

}  // namespace thiessen
