#pragma once

#include <string>
#include <vector>

#include "cli/options/option_list.h"
#include "geometry/point.h"

namespace thiessen::cli {

/// Gauges that close and open: `--without ID` and `--with X,Y`.
class WhatIfOptions : public OptionBlock {
 public:
  void declare(OptionList& options);
  /// Throws UsageError for an id that is given twice.
  void check() const;
  bool given() const { return !closed_.empty() || !opened_.empty(); }
  /// The ids of gauges that close.
  const std::vector<std::string>& closed() const { return closed_; }
  /// The places at which gauges open, in the coordinates of STATIONS.
  const std::vector<Point>& opened() const { return opened_; }

 private:
  std::vector<std::string> closed_;
  std::vector<Point> opened_;
};

}  // namespace thiessen::cli
