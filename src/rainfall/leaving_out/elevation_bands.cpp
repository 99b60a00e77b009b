#include "rainfall/leaving_out/elevation_bands.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "base/number.h"

namespace thiessen {
namespace {

/// The largest of 1, 2 and 5 times a power of ten that is no more than `limit`.
double round_step(double limit) {
  const double power = std::pow(10, std::floor(std::log10(limit)));
  for (const double times : {5.0, 2.0}) {
    if (times * power <= limit) return times * power;
  }
  return power;
}

/// The multiple of the step that is nearest to the value, as a person would write it: in binary 19
/// times 0.2 is a little more than 3.8.
double rounded(double value, double step) {
  const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step))));
  return parse_number(fixed_text(step * std::round(value / step), decimals)).value;
}

/// The bounds between bands, before it is looked at how many gauges each has.
std::vector<double> rounded_terciles(const std::vector<double>& sorted) {
  const double lower = sorted[sorted.size() / 3];
  const double upper = sorted[sorted.size() * 2 / 3];
  const double apart = upper > lower ? upper - lower : sorted.back() - sorted.front();
  if (!(apart > 0)) return {};
  const double step = round_step(apart / 4);
  std::vector<double> bounds;
  for (const double tercile : {lower, upper}) {
    const double bound = rounded(tercile, step);
    if (bounds.empty() || bound > bounds.back()) bounds.push_back(bound);
  }
  return bounds;
}

std::size_t count_below(const std::vector<double>& sorted, double bound) {
  return static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), bound) -
                                  sorted.begin());
}

/// Those of the bounds that leave enough gauges in each band.
std::vector<double> bounds_of(const std::vector<double>& sorted) {
  std::vector<double> bounds;
  std::size_t below = 0;
  for (const double bound : rounded_terciles(sorted)) {
    const std::size_t up_to = count_below(sorted, bound);
    const bool leaves_enough = up_to - below >= ElevationBands::least_gauges &&
                               sorted.size() - up_to >= ElevationBands::least_gauges;
    if (!leaves_enough) continue;
    bounds.push_back(bound);
    below = up_to;
  }
  return bounds;
}

/// The number with a comma between its thousands, for five digits in a row are hard to read.
std::string with_commas(double value) {
  std::string text = shortest_text(value);
  const std::size_t first = text.front() == '-' ? 1 : 0;
  const std::size_t end = std::min(text.find_first_not_of("0123456789", first), text.size());
  for (std::size_t at = end; at > first + 3; at -= 3) text.insert(at - 3, ",");
  return text;
}

std::vector<std::string> names_of(const std::vector<double>& bounds) {
  if (bounds.empty()) return {"all"};
  std::vector<std::string> names{"below " + with_commas(bounds.front())};
  for (std::size_t i = 1; i < bounds.size(); ++i)
    names.push_back(with_commas(bounds[i - 1]) + " to " + with_commas(bounds[i]));
  names.push_back("above " + with_commas(bounds.back()));
  return names;
}

}  // namespace

ElevationBands::ElevationBands(std::span<const double> elevations) {
  std::vector<double> sorted;
  for (const double elevation : elevations) {
    if (std::isfinite(elevation)) sorted.push_back(elevation);
  }
  band_of_.resize(elevations.size());
  if (sorted.empty()) return;
  std::sort(sorted.begin(), sorted.end());
  bounds_ = bounds_of(sorted);
  names_ = names_of(bounds_);
  for (std::size_t gauge = 0; gauge < elevations.size(); ++gauge) {
    if (!std::isfinite(elevations[gauge])) continue;
    const auto bound = std::upper_bound(bounds_.begin(), bounds_.end(), elevations[gauge]);
    band_of_[gauge] = static_cast<std::size_t>(bound - bounds_.begin());
  }
}

}  // namespace thiessen
