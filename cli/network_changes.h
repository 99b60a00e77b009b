#pragma once

#include <string>
#include <vector>

#include "cli/inputs.h"
#include "cli/options/option_list.h"
#include "rainfall/reporting.h"

namespace thiessen::cli {

/// Gauges that close and open: `--without ID` and `--with X,Y`.
class NetworkChanges : public OptionBlock {
 public:
  void declare(OptionList& options);
  bool given() const { return !closed_.empty() || !opened_.empty(); }
  /// In the coordinates of STATIONS.
  const std::vector<Point>& opened() const { return opened_; }

  /// Which stations there are before the changes and after, of those of inputs that were given
  /// the opened ones. Throws Error for ids that STATIONS lacks, with those that are most like them,
  /// and where no gauge is left; UsageError for an id given twice.
  ReportingStations before(const Inputs& inputs) const;
  ReportingStations after(const Inputs& inputs) const;
  /// Of opened gauges at a place with others that are there after the changes.
  void warn_of_shared_places(const Inputs& inputs, Warnings& warnings) const;
  /// Of gauges that open or close and weigh in no basin.
  void warn_of_no_effect(const Inputs& inputs, const std::vector<BasinWeights>& before,
                         const std::vector<BasinWeights>& after, Warnings& warnings) const;

 private:
  std::vector<std::string> closed_;
  std::vector<Point> opened_;
};

}  // namespace thiessen::cli
