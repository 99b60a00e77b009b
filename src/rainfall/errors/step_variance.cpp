#include "rainfall/errors/step_variance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thiessen {
namespace {

constexpr std::size_t looked_at = 12;
constexpr std::size_t taken = 3;
constexpr std::size_t least_reporting = 5;
/// In a larger network the degrees of freedom are computed from this many of its sites and scaled,
/// for the cost is the square of the number of pairs.
constexpr std::size_t most_told = 256;

}  // namespace

StepVariance::StepVariance(const Sites& sites, const Variogram& variogram)
    : sites_(sites), variogram_(variogram) {
  const auto near = sites.nearest_others(looked_at);
  double sum = 0;
  std::size_t count = 0;
  for (std::uint32_t site = 0; site < near.size(); ++site) {
    first_.push_back(near_.size());
    for (std::size_t k = 0; k < near[site].size(); ++k) {
      near_.push_back({near[site][k], variogram(sites[site], sites[near[site][k]])});
      if (k >= taken) continue;
      sum += near_.back().semivariance;
      ++count;
    }
  }
  first_.push_back(near_.size());
  floor_ = 0.1 * sum / static_cast<double>(std::max<std::size_t>(count, 1));
  degrees_ = degrees_of_all();
}

FieldVariance StepVariance::of(std::span<const double> readings) const {
  FieldVariance result{std::numeric_limits<double>::quiet_NaN(), 0, 0};
  double squares = 0;
  double expected = 0;
  const auto add = [&](double difference, double semivariance) {
    const double w = weight(semivariance);
    squares += w * difference * difference;
    expected += 2 * w * semivariance;
  };
  std::uint32_t last_alone = 0;  // the last reporting site if none of its near sites reports
  bool any_alone = false;
  for (std::uint32_t site = 0; site < readings.size(); ++site) {
    const double reading = readings[site];
    if (std::isnan(reading)) continue;
    ++result.gauges;
    if (any_alone) {
      add(reading - readings[last_alone], variogram_(sites_[site], sites_[last_alone]));
      any_alone = false;
    }
    std::size_t found = 0;
    for (std::size_t k = first_[site]; k < first_[site + 1] && found < taken; ++k) {
      const double other = readings[near_[k].site];
      if (std::isnan(other)) continue;
      add(reading - other, near_[k].semivariance);
      ++found;
    }
    if (found > 0) continue;
    any_alone = true;
    last_alone = site;
  }
  result.is_even = result.gauges >= least_reporting && squares == 0;
  if (result.gauges < least_reporting || !(squares > 0) || !(expected > 0)) return result;
  result.variance = squares / expected;
  result.degrees = degrees_of(result.gauges);
  return result;
}

FieldVariance StepVariance::of(std::span<const SquaredDifference> differences,
                               std::size_t gauges) const {
  double squares = 0;
  double expected = 0;
  for (const SquaredDifference& d : differences) {
    const double semivariance = variogram_(sites_[d.a], sites_[d.b]);
    squares += weight(semivariance) * d.square;
    expected += 2 * weight(semivariance) * semivariance;
  }
  FieldVariance result{std::numeric_limits<double>::quiet_NaN(), 0, gauges};
  result.is_even = gauges >= least_reporting && !(squares > 0);
  if (gauges < least_reporting || !(squares > 0) || !(expected > 0)) return result;
  result.variance = squares / expected;
  result.degrees = degrees_of(gauges);
  return result;
}

double StepVariance::degrees_of(std::size_t gauges) const {
  return degrees_ * static_cast<double>(gauges - 1) /
         static_cast<double>(std::max<std::size_t>(sites_.size(), 2) - 1);
}

std::vector<StepVariance::Pair> StepVariance::pairs_of_all(std::size_t sites) const {
  std::vector<Pair> pairs;
  for (std::uint32_t site = 0; site < sites; ++site) {
    const std::size_t end = std::min(first_[site + 1], first_[site] + taken);
    for (std::size_t k = first_[site]; k < end; ++k) {
      if (near_[k].site < sites) pairs.push_back({site, near_[k].site, near_[k].semivariance});
    }
  }
  return pairs;
}

// The degrees of freedom of a weighted sum of squares of normal differences are twice the square of
// its mean over its variance. That variance is twice the sum of the squares of all their
// covariances.
double StepVariance::degrees_of_all() const {
  const std::size_t told = std::min(sites_.size(), most_told);
  const std::vector<Pair> pairs = pairs_of_all(told);
  const auto between = [&](std::uint32_t a, std::uint32_t b) {
    return a == b ? 0 : variogram_(sites_[a], sites_[b]);
  };
  double mean = 0;
  double covariances = 0;
  for (const Pair& p : pairs) {
    mean += 2 * weight(p.semivariance) * p.semivariance;
    for (const Pair& q : pairs) {
      const double covariance =
          between(p.a, q.b) + between(p.b, q.a) - between(p.a, q.a) - between(p.b, q.b);
      covariances += weight(p.semivariance) * weight(q.semivariance) * covariance * covariance;
    }
  }
  if (!(covariances > 0)) return 0;
  const double degrees = mean * mean / covariances;
  return degrees * static_cast<double>(sites_.size() - 1) / static_cast<double>(told - 1);
}

double StepVariance::widening(double degrees) {
  constexpr double z = 1.959963984540054;
  constexpr double z2 = z * z;
  const double v = std::max(degrees, 2.0);
  const double first = (z2 + 1) / 4;
  const double second = ((5 * z2 + 16) * z2 + 3) / 96;
  const double third = (((3 * z2 + 19) * z2 + 17) * z2 - 15) / 384;
  return 1 + first / v + second / (v * v) + third / (v * v * v);
}

}  // namespace thiessen
