#pragma once

#include "base/file.h"
#include "results/models/stepped_series.h"

namespace thiessen {

/// HYPE's forcing of precipitation, Pobs.txt: a tab-separated table with a column a basin, whose
/// name is a whole number, and a row a step, dated by its beginning, with a clock where steps are
/// shorter than a day. Missing values are -9999.
///
/// Source: SMHI, HYPE documentation (HYPE wiki), HYPE file reference: Pobs.txt.
class HypeSeries : public SteppedSeries {
 public:
  /// The file must outlive it. Throws Error where an id is no whole number from 0 to 2147483647,
  /// where two are the same number, and where the unit is not mm.
  HypeSeries(OutputFile& file, ModelSubject subject);

 private:
  void write(const Steps& steps, Warnings& warnings) override;

  OutputFile& file_;
};

}  // namespace thiessen
