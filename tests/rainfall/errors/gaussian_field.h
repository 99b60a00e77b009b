#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <utility>
#include <vector>

#include "geometry/point.h"
#include "geometry/seeded.h"

namespace thiessen {

/// Stationary normal fields of mean 0 and variance 1 at some points, drawn by Cholesky's method:
/// the point whose value those before tell least comes next, until all are told to a millionth of
/// the variance, so that smooth fields, whose correlations have no inverse in doubles, do no harm.
class GaussianField {
 public:
  using Correlation = std::function<double(double distance)>;

  GaussianField(const std::vector<Point>& points, const Correlation& correlation)
      : points_(points.size()) {
    std::vector<double> untold(points.size(), 1.0);
    while (columns_.size() < points.size()) {
      const auto next =
          static_cast<std::size_t>(std::max_element(untold.begin(), untold.end()) - untold.begin());
      if (untold[next] < 1e-6) break;
      std::vector<double> column(points.size());
      for (std::size_t i = 0; i < points.size(); ++i) {
        column[i] =
            correlation(std::hypot(points[i].x - points[next].x, points[i].y - points[next].y));
      }
      for (const auto& before : columns_) {
        for (std::size_t i = 0; i < points.size(); ++i) column[i] -= before[next] * before[i];
      }
      const double scale = 1 / std::sqrt(untold[next]);
      for (std::size_t i = 0; i < points.size(); ++i) {
        column[i] *= scale;
        untold[i] -= column[i] * column[i];
      }
      untold[next] = 0;
      columns_.push_back(std::move(column));
    }
  }

  std::vector<double> draw(Seeded& seeded) const {
    std::normal_distribution<double> normal;
    std::vector<double> field(points_);
    for (const auto& column : columns_) {
      const double independent = normal(seeded.generator());
      for (std::size_t i = 0; i < points_; ++i) field[i] += column[i] * independent;
    }
    return field;
  }

 private:
  std::size_t points_;
  std::vector<std::vector<double>> columns_;
};

}  // namespace thiessen
