#include "rainfall/errors/variogram_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace thiessen {
namespace {

struct Weighted {
  double distance;
  double semivariance;
  double weight;
};

struct Fit {
  VariogramModel model;
  double misfit = std::numeric_limits<double>::infinity();
};

/// Solves for the nugget and the sill that fit best with the model's range and exponent.
Fit with_linear_solved(VariogramModel model, const std::vector<Weighted>& classes) {
  double w = 0, g = 0, gg = 0, y = 0, gy = 0, yy = 0;
  for (const Weighted& c : classes) {
    const double rise = model.rise(c.distance);
    w += c.weight;
    g += c.weight * rise;
    gg += c.weight * rise * rise;
    y += c.weight * c.semivariance;
    gy += c.weight * rise * c.semivariance;
    yy += c.weight * c.semivariance * c.semivariance;
  }
  const auto misfit = [&](double nugget, double sill) {
    return yy + nugget * nugget * w + sill * sill * gg +
           2 * (nugget * sill * g - nugget * y - sill * gy);
  };
  Fit best;
  const auto consider = [&](double nugget, double sill) {
    if (!(nugget >= 0 && sill >= 0)) return;
    const double its = std::max(0.0, misfit(nugget, sill));
    if (!(its < best.misfit)) return;
    model.nugget = nugget;
    model.sill = sill;
    best = {model, its};
  };
  consider(y / w, 0);
  if (gg > 0) consider(0, gy / gg);
  const double determinant = w * gg - g * g;
  if (determinant > 1e-12 * w * gg)
    consider((gg * y - g * gy) / determinant, (w * gy - g * y) / determinant);
  return best;
}

/// The ranges and exponents that a grid covers.
struct Window {
  double low_range, high_range;
  double low_exponent, high_exponent;
};

constexpr int range_steps = 32;
constexpr int exponent_steps = 14;
constexpr double least_exponent = 0.25;
constexpr double largest_exponent = 2;

Fit best_of_window(const Window& window, VariogramModel::Shape shape,
                   const std::vector<Weighted>& classes) {
  Fit best;
  const bool varies = window.low_exponent < window.high_exponent;
  const int exponents = shape == VariogramModel::Shape::stable && varies ? exponent_steps : 0;
  for (int i = 0; i <= range_steps; ++i) {
    VariogramModel model{shape};
    model.range = window.low_range * std::pow(window.high_range / window.low_range,
                                              static_cast<double>(i) / range_steps);
    for (int j = 0; j <= exponents; ++j) {
      model.exponent = window.low_exponent +
                       (window.high_exponent - window.low_exponent) * j / std::max(exponents, 1);
      const Fit fit = with_linear_solved(model, classes);
      if (fit.misfit < best.misfit) best = fit;
    }
  }
  return best;
}

Window round_best(const Window& window, const VariogramModel& best) {
  const double ratio = std::pow(window.high_range / window.low_range, 1.5 / range_steps);
  const double width = 1.5 * (window.high_exponent - window.low_exponent) / exponent_steps;
  return {best.range / ratio, best.range * ratio, std::max(least_exponent, best.exponent - width),
          std::min(largest_exponent, best.exponent + width)};
}

/// What a model may be.
struct Family {
  VariogramModel::Shape shape;
  double low_exponent = least_exponent;
  double high_exponent = largest_exponent;
};

Fit best_of_family(const Family& family, const std::vector<Weighted>& classes) {
  double least = std::numeric_limits<double>::infinity();
  double largest = 0;
  for (const Weighted& c : classes) {
    if (c.distance > 0) least = std::min(least, c.distance);
    largest = std::max(largest, c.distance);
  }
  Window window{least / 3, largest * 10, family.low_exponent, family.high_exponent};
  Fit best;
  for (int laid = 0; laid <= 3; ++laid) {
    const Fit fit = best_of_window(window, family.shape, classes);
    if (fit.misfit < best.misfit) best = fit;
    window = round_best(window, best.model);
  }
  return best;
}

/// The model of these families that fits best.
VariogramModel fit(std::span<const DistanceClass> classes, std::span<const Family> families) {
  double largest = 0;
  for (const DistanceClass& c : classes) largest = std::max(largest, c.semivariance);
  // The first round weighs a class by its own semivariance. The next rounds take the model's value,
  // which is not misled by a class that is low by chance.
  const auto weight = [&](const DistanceClass& c, double semivariance) {
    const double floored = std::max(semivariance, 1e-3 * largest);
    return c.pairs / (floored * floored);
  };
  std::vector<Weighted> weighted;
  for (const DistanceClass& c : classes)
    weighted.push_back({c.distance, c.semivariance, weight(c, c.semivariance + 0.05 * largest)});
  Fit best;
  for (int round = 0; round < 3; ++round) {
    best = {};
    for (const Family& family : families) {
      const Fit its = best_of_family(family, weighted);
      if (its.misfit < best.misfit) best = its;
    }
    for (std::size_t i = 0; i < classes.size(); ++i)
      weighted[i].weight = weight(classes[i], best.model(classes[i].distance));
  }
  return best.model;
}

}  // namespace

VariogramModel fit_variogram(std::span<const DistanceClass> classes) {
  using Shape = VariogramModel::Shape;
  return fit(classes, std::array{Family{Shape::stable}, Family{Shape::spherical}});
}

VariogramModel fit_exponential(std::span<const DistanceClass> classes) {
  return fit(classes, std::array{Family{VariogramModel::Shape::stable, 1, 1}});
}

}  // namespace thiessen
