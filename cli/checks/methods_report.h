#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "cli/inputs/inputs.h"
#include "rainfall/leaving_out/dated_sample.h"
#include "rainfall/series/stamp.h"
#include "rainfall/series/step_months.h"

namespace thiessen::cli {

/// The elevations of the network's stations by the first of the fields elev, elevation, z, alt and
/// altitude that STATIONS has, which was read with its attributes; NaN where a station has none,
/// and nothing without such a field.
std::vector<double> elevations_in_attributes(const StudyFiles& study);

/// What `check --methods` says: leaving each gauge out, which method is how far off. A series that
/// is longer than `most_readings` is looked at in evenly spaced steps, which memory and time are
/// bounded by.
class MethodsReport {
 public:
  static constexpr std::size_t most_readings = 1'000'000;

  /// The inputs must outlive it. `elevations` has an entry for each station, or none.
  MethodsReport(const Inputs& inputs, std::vector<double> elevations, std::string rainfall,
                Stamp stamp);

  void add(const TimeStep& step);
  /// The report on what has been added, in lines; `unit` may be empty.
  std::string text(const std::string& unit, unsigned threads) const;

 private:
  const Inputs& inputs_;
  std::vector<double> elevations_;
  StepMonths months_;
  Stamp stamp_;
  DatedSample sample_;
};

}  // namespace thiessen::cli
