#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rainfall/series/rain_periods.h"
#include "results/rain_file.h"
#include "results/rain_totals_file.h"

namespace thiessen::cli {

/// rain.csv as the options want it: the steps, or their totals over periods.
class RainTable {
 public:
  /// `rainfall` is the file of the readings, for messages. The file and the basins must outlive it.
  RainTable(OutputFile& file, const std::vector<Basin>& basins, const RainFormat& format,
            const std::optional<Totalling>& totalling, const std::string& rainfall);
  RainTable(const RainTable&) = delete;
  RainTable& operator=(const RainTable&) = delete;

  /// Makes a step's rows, where they need nothing that comes in order. Safe for several threads.
  void prepare(RainStep& step) const;
  /// `pattern`: of its gauges, where the format has such a column.
  void add(const RainStep& step, std::size_t pattern = 0);
  /// Writes what is still held, and warns of what is odd about it; nothing comes after.
  void finish(Warnings& warnings);

 private:
  bool has_patterns_;
  std::optional<RainFile> steps_;
  std::optional<RainTotalsFile> totals_;
  std::optional<RainPeriods> periods_;
};

}  // namespace thiessen::cli
