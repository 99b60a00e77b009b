#pragma once

#include <string>
#include <vector>

#include "base/file.h"
#include "basin/basin.h"
#include "rainfall/series/rain_periods.h"
#include "results/rain_file.h"

namespace thiessen {

/// Writes totals of areal rainfall, a period at a time: CSV `time,<basin id>,<basin
/// id>_missing,...` or `time,basin[,method],rainfall,missing`. The field of a missing total is
/// empty.
class RainTotalsFile {
 public:
  /// Writes the header. The file and the basins must outlive it. Throws Error where two columns
  /// would have one name.
  RainTotalsFile(OutputFile& file, const std::vector<Basin>& basins, RainFormat format);
  void add(const RainPeriod& period);

 private:
  void write_header();
  void append_total(const BasinTotal& total);

  OutputFile& file_;
  const std::vector<Basin>& basins_;
  RainFormat format_;
  std::string row_;
};

}  // namespace thiessen
