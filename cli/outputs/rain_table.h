#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cli/outputs/rain_output.h"
#include "rainfall/series/rain_totals.h"
#include "results/rain_file.h"
#include "results/rain_growth.h"
#include "results/rain_totals_file.h"

namespace thiessen::cli {

/// Writes rain.csv as the options want it: the steps, or their totals over periods.
class RainTable : public RainOutput {
 public:
  /// `rainfall` is the file of the readings, for messages. Where there is a `growth`, only steps
  /// are written that a table lacks. The file, the basins and the growth must outlive the table.
  RainTable(OutputFile& file, const std::vector<Basin>& basins, const RainFormat& format,
            const std::optional<Totalling>& totalling, const std::string& rainfall,
            RainGrowth* growth = nullptr);
  RainTable(const RainTable&) = delete;
  RainTable& operator=(const RainTable&) = delete;

  /// Has each row's time and values, by basin or by basin and method, told to `hear` as well.
  void tell(std::function<void(const std::string& time, std::span<const double> values)> hear) {
    hear_ = std::move(hear);
  }
  void prepare(RainStep& step) const override;
  void add(const RainStep& step, std::size_t pattern) override;
  void add(const RainStep& step) { add(step, 0); }
  void finish(Warnings& warnings) override;

 private:
  void add(const RainPeriod& period);
  bool is_there(const RainStep& step);
  bool is_there(const RainPeriod& period);
  std::string with_line_ends(std::string text) const;

  bool has_patterns_;
  bool has_rows_for_basins_;
  bool has_errors_;
  bool iso_times_;
  std::string rainfall_;
  std::optional<RainFile> steps_;
  std::optional<RainTotalsFile> totals_;
  std::unique_ptr<RainTotals> periods_;
  RainGrowth* growth_;
  std::function<void(const std::string& time, std::span<const double> values)> hear_;
  std::vector<double> values_;  ///< of the step that may be there, or is told
};

}  // namespace thiessen::cli
