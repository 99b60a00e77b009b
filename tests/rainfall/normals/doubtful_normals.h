#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "rainfall/normals/uniform_normals.h"

namespace thiessen {

/// Normals of the year of gauges, and of basins whose logarithms have an error.
class DoubtfulNormals : public NormalField {
 public:
  DoubtfulNormals(std::vector<double> gauges, const std::vector<double>& basins,
                  const std::vector<double>& log_variances)
      : gauges_(std::move(gauges)) {
    for (std::size_t b = 0; b < basins.size(); ++b)
      basins_.emplace_back(basins[b], log_variances[b]);
  }
  DoubtfulNormals(std::vector<double> gauges, const std::vector<double>& basins,
                  double log_variance)
      : DoubtfulNormals(std::move(gauges), basins,
                        std::vector<double>(basins.size(), log_variance)) {}

  std::size_t months() const override { return 1; }
  double at_gauge(StationIndex station, std::size_t) const override {
    return gauges_[index(station)];
  }
  const BasinNormals& in(std::size_t basin) const override { return basins_[basin]; }

 private:
  class OfBasin : public UniformBasinNormals {
   public:
    OfBasin(double normal, double log_variance)
        : UniformBasinNormals({normal}), log_variance_(log_variance) {}
    double log_variance(std::size_t) const override { return log_variance_; }

   private:
    double log_variance_;
  };

  std::vector<double> gauges_;
  std::vector<OfBasin> basins_;
};

}  // namespace thiessen
