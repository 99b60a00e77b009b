#include "rainfall/errors/distance_classes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <span>
#include <utility>

#include "base/parallel.h"

namespace thiessen {
namespace {

constexpr std::size_t most_pairs = 20'000;
constexpr double classes_an_octave = 4;

struct Pair {
  std::uint32_t a;
  std::uint32_t b;
  double semivariance = 0;
  bool counts = false;
};

/// A gauge's readings less their mean, divided by their standard deviation. Empty where the gauge
/// has too few readings or all are the same.
std::vector<float> standardised(const StepSample& sample, std::size_t site) {
  double sum = 0;
  std::size_t count = 0;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (std::size_t t = 0; t < sample.steps(); ++t) {
    const double reading = sample[t][site];
    if (std::isnan(reading)) continue;
    sum += reading;
    ++count;
    low = std::min(low, reading);
    high = std::max(high, reading);
  }
  if (count < least_steps || low == high) return {};
  const double mean = sum / static_cast<double>(count);
  double squares = 0;
  for (std::size_t t = 0; t < sample.steps(); ++t) {
    const double reading = sample[t][site];
    if (!std::isnan(reading)) squares += (reading - mean) * (reading - mean);
  }
  const double scale = std::sqrt(static_cast<double>(count) / squares);
  std::vector<float> series(sample.steps());
  for (std::size_t t = 0; t < series.size(); ++t)
    series[t] = static_cast<float>((sample[t][site] - mean) * scale);
  return series;
}

void measure(std::span<const float> a, std::span<const float> b, Pair& pair) {
  constexpr std::size_t lanes = 4;
  float sums[lanes] = {};
  float counts[lanes] = {};
  double sum = 0;
  double count = 0;
  const auto settle = [&] {
    for (std::size_t k = 0; k < lanes; ++k) {
      sum += static_cast<double>(sums[k]);
      count += static_cast<double>(counts[k]);
      sums[k] = counts[k] = 0;
    }
  };
  constexpr std::size_t run = 64;  // short, for sums of floats lose digits as they grow
  for (std::size_t begin = 0; begin < a.size(); begin += run) {
    const std::size_t end = std::min(a.size(), begin + run);
    std::size_t t = begin;
    for (; t + lanes <= end; t += lanes) {
      for (std::size_t k = 0; k < lanes; ++k) {
        const float d = a[t + k] - b[t + k];
        const bool both = d == d;
        sums[k] += both ? d * d : 0.0F;
        counts[k] += both ? 1.0F : 0.0F;
      }
    }
    for (; t < end; ++t) {
      const float d = a[t] - b[t];
      if (d != d) continue;
      sums[0] += d * d;
      counts[0] += 1;
    }
    settle();
  }
  pair.counts = count >= static_cast<double>(least_steps);
  pair.semivariance = sum / (2 * count);
}

/// How far apart along the order of gauges pairs are taken: 1, 2, 3, 4, 6, 8, 12 ...
std::vector<std::size_t> spread_lags(std::size_t gauges) {
  std::vector<std::size_t> lags;
  for (std::size_t lag = 1; lag < gauges; lag *= 2) {
    lags.push_back(lag);
    if (lag >= 2 && lag + lag / 2 < gauges) lags.push_back(lag + lag / 2);
  }
  return lags;
}

std::vector<Pair> pairs_of(const std::vector<std::uint32_t>& gauges) {
  std::vector<Pair> pairs;
  const std::size_t n = gauges.size();
  if (n * (n - 1) / 2 <= most_pairs) {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i + 1; j < n; ++j) pairs.push_back({gauges[i], gauges[j]});
    }
    return pairs;
  }
  const std::vector<std::size_t> lags = spread_lags(n);
  for (const std::size_t lag : lags) {
    const std::size_t there = n - lag;
    const std::size_t taken = std::min(there, most_pairs / lags.size());
    for (std::size_t k = 0; k < taken; ++k) {
      const std::size_t i = k * there / taken;
      pairs.push_back({gauges[i], gauges[i + lag]});
    }
  }
  return pairs;
}

std::vector<DistanceClass> classes_of(const std::vector<Pair>& pairs, const Sites& sites) {
  struct Sum {
    double distance = 0;
    double semivariance = 0;
    double pairs = 0;
  };
  // Classes are counted from the longest distance, so that the unit does not matter. The longest
  // distance lies in the middle of a class, so that on a lattice of gauges rounding does not part
  // equal distances.
  double longest = 0;
  for (const Pair& pair : pairs) {
    if (pair.counts) longest = std::max(longest, square_distance(sites[pair.a], sites[pair.b]));
  }
  longest = std::sqrt(longest);
  std::map<int, Sum> sums;
  for (const Pair& pair : pairs) {
    if (!pair.counts) continue;
    const double distance = std::sqrt(square_distance(sites[pair.a], sites[pair.b]));
    // Two places may have the same point in space; such pairs form a class below all others.
    const double octave = distance > 0 ? std::log2(distance / longest) : -2200;
    Sum& sum = sums[static_cast<int>(std::floor(classes_an_octave * octave + 0.5))];
    sum.distance += distance;
    sum.semivariance += pair.semivariance;
    sum.pairs += 1;
  }
  std::vector<DistanceClass> classes;
  classes.reserve(sums.size());
  for (const auto& [number, sum] : sums)
    classes.push_back({sum.distance / sum.pairs, sum.semivariance / sum.pairs, sum.pairs});
  return classes;
}

std::string count_of(std::size_t count, const char* thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

}  // namespace

DistanceClasses distance_classes(const StepSample& sample, const Sites& sites, unsigned threads) {
  if (sample.steps() < least_steps) {
    return {{},
            count_of(sample.steps(), "time step") +
                " cannot tell how gauges differ with distance: " + std::to_string(least_steps) +
                " are needed"};
  }
  std::vector<std::vector<float>> series(sites.size());
  in_parallel(series.size(), threads,
              [&](std::size_t, std::size_t site) { series[site] = standardised(sample, site); });
  std::vector<std::uint32_t> gauges;
  for (std::uint32_t site = 0; site < series.size(); ++site) {
    if (!series[site].empty()) gauges.push_back(site);
  }
  if (gauges.size() < least_gauges) {
    return {
        {},
        "of " + count_of(sites.size(), "place") + " with gauges " + std::to_string(gauges.size()) +
            (gauges.size() == 1 ? " has " : " have ") + std::to_string(least_steps) +
            " readings that are not all the same: " + std::to_string(least_gauges) + " are needed"};
  }
  std::vector<Pair> pairs = pairs_of(gauges);
  in_parallel(pairs.size(), threads, [&](std::size_t, std::size_t i) {
    measure(series[pairs[i].a], series[pairs[i].b], pairs[i]);
  });
  DistanceClasses result{classes_of(pairs, sites), ""};
  double counted = 0;
  double largest = 0;
  for (const DistanceClass& c : result.classes) {
    counted += c.pairs;
    largest = std::max(largest, c.semivariance);
  }
  constexpr double least_pairs = least_gauges * (least_gauges - 1) / 2.0;
  if (counted < least_pairs) {
    return {{},
            count_of(static_cast<std::size_t>(counted), "pair") + " of gauges share " +
                std::to_string(least_steps) + " steps at which both report: " +
                std::to_string(static_cast<int>(least_pairs)) + " are needed"};
  }
  // A semivariance below the accuracy of floats means that all gauges read the same, to a factor
  // and a constant.
  if (largest < 1e-12) return {{}, "all gauges read alike at all steps"};
  return result;
}

std::vector<DistanceClass> distance_classes(std::span<const double> values, const Sites& sites) {
  std::vector<std::uint32_t> gauges(values.size());
  std::iota(gauges.begin(), gauges.end(), 0u);
  std::vector<Pair> pairs = pairs_of(gauges);
  for (Pair& pair : pairs) {
    const double difference = values[pair.a] - values[pair.b];
    pair.semivariance = difference * difference / 2;
    pair.counts = true;
  }
  return classes_of(pairs, sites);
}

}  // namespace thiessen
