#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cli/session.h"
#include "rainfall/rain_series.h"

namespace thiessen::cli {

/// What `run` says in the end: for each basin its area, the gauges inside and weighing, the largest
/// weight, the mean rainfall and its standard error, the largest, and the steps without a value.
class Summary {
 public:
  Summary(const Session& session, const std::vector<BasinWeights>& weights);
  void add(const RainStep& step);
  /// Of the mean over all steps, by basin; NaN where it cannot be had, as without this.
  void set_errors_of_mean(std::vector<double> errors) { errors_ = std::move(errors); }
  /// Lines of aligned columns.
  std::string text(const std::string& units) const;

 private:
  struct Line {
    std::size_t inside = 0;
    double sum = 0;
    double largest = 0;
    std::size_t values = 0;
    std::size_t empty = 0;
  };
  const Session& session_;
  const std::vector<BasinWeights>& weights_;
  std::vector<Line> lines_;
  std::vector<double> errors_;
};

}  // namespace thiessen::cli
