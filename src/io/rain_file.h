#pragma once

#include <string>
#include <vector>

#include "base/file.h"
#include "basin/basin.h"
#include "rainfall/rain_series.h"

namespace thiessen {

struct RainFormat {
  bool rows_for_basins = false;  ///< a row a basin and step (--long), and not a column a basin
  int decimals = 3;
};

/// Writes the series of areal rainfall, a step at a time: CSV `time,<basin id>,...`, or
/// `time,basin,rainfall,gauges,coverage`. A value that cannot be had is empty.
class RainFile {
 public:
  /// Writes the header. The file and the basins must outlive it.
  RainFile(OutputFile& file, const std::vector<Basin>& basins, RainFormat format);
  void add(const RainStep& step);

 private:
  void add_row_for_each_basin(const RainStep& step);

  OutputFile& file_;
  const std::vector<Basin>& basins_;
  RainFormat format_;
  std::string row_;
};

}  // namespace thiessen
