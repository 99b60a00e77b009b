#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rainfall/series/rain_periods.h"
#include "results/rain_file.h"
#include "results/rain_totals_file.h"

namespace thiessen::cli {

/// Writes rain.csv as the options want it: the steps, or their totals over periods.
class RainTable {
 public:
  /// `rainfall` is the file of the readings, for messages. The file and the basins must outlive the
  /// table.
  RainTable(OutputFile& file, const std::vector<Basin>& basins, const RainFormat& format,
            const std::optional<Totalling>& totalling, const std::string& rainfall);
  RainTable(const RainTable&) = delete;
  RainTable& operator=(const RainTable&) = delete;

  /// Makes a step's rows ahead of time, where they need nothing that is known only in the order of
  /// the steps. Safe for several threads.
  void prepare(RainStep& step) const;
  /// Adds the next step in order. `pattern` is the number of its set of reporting gauges, and is
  /// used where the format has such a column.
  void add(const RainStep& step, std::size_t pattern = 0);
  /// Writes what is still held, and warns of what is odd about it. No step may be added afterwards.
  void finish(Warnings& warnings);

 private:
  bool has_patterns_;
  bool iso_times_;
  std::string rainfall_;
  std::optional<RainFile> steps_;
  std::optional<RainTotalsFile> totals_;
  std::optional<RainPeriods> periods_;
};

}  // namespace thiessen::cli
