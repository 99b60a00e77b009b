#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "basin/shapes.h"
#include "geometry/seeded.h"
#include "rainfall/errors/gaussian_field.h"
#include "rainfall/network/network.h"

namespace thiessen {

/// Quarters of the unit square.
inline std::vector<Basin> quarters() {
  std::vector<Basin> basins;
  for (const Point low : {Point{0, 0}, Point{0.5, 0}, Point{0, 0.5}, Point{0.5, 0.5}}) {
    basins.push_back(shapes::basin({{shapes::rectangle(low, {low.x + 0.5, low.y + 0.5}), {}}}));
  }
  return basins;
}

struct SeriesSetting {
  const char* name;
  double lasting;  ///< share of the variance that is the same at all steps
  double share_silent;
  std::size_t steps;
};

/// A network of 40 gauges and what it reads in a series; the true means of the quarters.
class LastingSeries {
 public:
  LastingSeries(Seeded& seeded, const SeriesSetting& setting) {
    for (int g = 0; g < 40; ++g) {
      points_.push_back({seeded.uniform(-0.1, 1.1), seeded.uniform(-0.1, 1.1)});
      stations_.push_back({std::to_string(g), points_.back(), 0});
    }
    for (int i = 0; i < side; ++i) {
      for (int j = 0; j < side; ++j) points_.push_back({(i + 0.5) / side, (j + 0.5) / side});
    }
    const GaussianField field(points_, [](double d) { return std::exp(-d / 0.5); });
    const std::vector<double> lasting = field.draw(seeded);
    std::normal_distribution<double> normal;
    truth_.assign(4, 0);
    for (std::size_t t = 0; t < setting.steps; ++t) {
      std::vector<double> values = field.draw(seeded);
      const double common = 20 + 4 * normal(seeded.generator());  // what all gauges share
      for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = common + std::sqrt(1 - setting.lasting) * values[i] +
                    std::sqrt(setting.lasting) * lasting[i];
      }
      add_truth(values, static_cast<double>(setting.steps));
      values.resize(stations_.size());
      for (double& r : values) {
        if (seeded.uniform(0, 1) < setting.share_silent)
          r = std::numeric_limits<double>::quiet_NaN();
      }
      steps_.push_back(std::move(values));
    }
  }

  const std::vector<Station>& stations() const { return stations_; }
  const std::vector<std::vector<double>>& steps() const { return steps_; }
  double truth(std::size_t basin) const { return truth_[basin]; }

 private:
  static constexpr int side = 12;

  void add_truth(const std::vector<double>& values, double steps) {
    for (int i = 0; i < side; ++i) {
      for (int j = 0; j < side; ++j) {
        const std::size_t quarter = (i < side / 2 ? 0U : 1U) + (j < side / 2 ? 0U : 2U);
        const double value = values[stations_.size() + static_cast<std::size_t>(i * side + j)];
        truth_[quarter] += value * 4 / (side * side) / steps;
      }
    }
  }

  std::vector<Point> points_;
  std::vector<Station> stations_;
  std::vector<std::vector<double>> steps_;
  std::vector<double> truth_;
};

}  // namespace thiessen
