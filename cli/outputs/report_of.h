#pragma once

#include <string>
#include <vector>

#include "cli/checks/check_report.h"
#include "cli/inputs/inputs.h"
#include "cli/options/option_list.h"
#include "cli/summary/summary.h"
#include "map/sheet/picture.h"
#include "rainfall/gaps/gap_policy.h"
#include "rainfall/series/gauge_readings.h"
#include "rainfall/series/rain_series.h"
#include "report/thinned_series.h"
#include "results/provenance.h"

namespace thiessen::cli {

/// What the page of a study is made of beside the inputs and the series.
struct ReportParts {
  const Picture* picture = nullptr;
  const Summary* summary = nullptr;
  const std::vector<BasinWeights>* weights = nullptr;
  const OptionList* options = nullptr;
  Provenance made_by{};
  std::string unit{};
  Gaps gaps = Gaps::retessellate;  ///< what a step with silent gauges got
  bool has_totals = false;         ///< whether rain.csv has totals over periods, and not the steps
};

/// Gathers what report.html shows while the steps of a run pass: the page shows the steps of
/// RAINFALL, also where rain.csv has totals over periods.
class StudyReport {
 public:
  /// The inputs must outlive the report.
  explicit StudyReport(const Inputs& inputs);
  void add(const RainStep& step);
  /// The page. It tells the warnings and notices that were given by now. Reads the inputs' files
  /// once more, for their SHA-256. Throws Error where one cannot be read.
  std::string page(const ReportParts& parts, const Warnings& warnings) const;

 private:
  std::vector<std::string> findings(const ReportParts& parts, const Warnings& warnings) const;

  const Inputs& inputs_;
  ThinnedSeries series_;
  PassedSteps passed_;
  std::vector<double> values_;  ///< of the step that is added
};

}  // namespace thiessen::cli
