#include "rainfall/errors/error_correlation.h"

#include <algorithm>
#include <cmath>

#include "base/number.h"
#include "rainfall/errors/sites.h"

namespace thiessen {
namespace {

constexpr std::size_t near_ones = 2;
constexpr std::size_t most_pairs = 256;
/// Differences of pairs that share a gauge, or lie side by side, are not independent: so many count
/// as one.
constexpr double pairs_that_are_one = 4;

}  // namespace

void warn_of_lasting_errors(const ErrorCorrelation& correlation, const std::string& file,
                            Warnings& warnings) {
  if (!(correlation.lasting > 0)) return;
  std::string share;
  append_fixed(share, 100 * correlation.lasting, 1);
  warnings.add({file, 0,
                "near gauges differ for good: " + share +
                    " % of the square of an error lasts from step to step, which the errors of "
                    "totals count alike in plains and mountains",
                "normals tell where it is wetter: " + setting("normals") + ", " +
                    setting("normal_field") + ", " + setting("elevation")});
}

DifferencesInTime::DifferencesInTime(const Network& network, Metric metric) {
  const Sites sites(network.places(), metric);
  const auto near = sites.nearest_others(near_ones);
  std::vector<Pair> all;
  for (std::uint32_t a = 0; a < near.size(); ++a) {
    for (const std::uint32_t b : near[a]) {
      const bool from_b = std::find(near[b].begin(), near[b].end(), a) != near[b].end();
      if (a < b || !from_b) {
        all.push_back({static_cast<std::uint32_t>(sites.place_of(a)),
                       static_cast<std::uint32_t>(sites.place_of(b))});
      }
    }
  }
  const std::size_t taken = std::min(all.size(), most_pairs);
  for (std::size_t i = 0; i < taken; ++i) pairs_.push_back(all[i * all.size() / taken]);
  steps_.resize(most_lags + 1, {std::vector<double>(taken), std::vector<double>(taken), 0});
  lags_.resize(most_lags + 1);
  sums_.resize(taken);
  scales_.resize(taken);
}

void DifferencesInTime::add(std::span<const double> of_places) {
  Step& now = steps_[count_ % steps_.size()];
  double squares = 0;
  double there = 0;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const double difference = of_places[pairs_[i].b] - of_places[pairs_[i].a];
    const bool is_there = !std::isnan(difference);
    now.differences[i] = is_there ? difference : 0;
    now.are_there[i] = is_there ? 1 : 0;
    squares += now.differences[i] * now.differences[i];
    there += now.are_there[i];
  }
  now.scale = there > 0 ? std::sqrt(squares / there) : 0;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    sums_[i] += now.differences[i];
    scales_[i] += now.are_there[i] * now.scale;
  }
  ++count_;
  for (std::size_t k = 0; k < std::min(count_, steps_.size()); ++k)
    add_lag(now, steps_[(count_ - 1 - k) % steps_.size()], lags_[k]);
}

void DifferencesInTime::add_lag(const Step& now, const Step& before, Lag& lag) const {
  const double scales = now.scale * before.scale;
  if (scales == 0) return;
  double products = 0;
  double both = 0;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    products += now.differences[i] * before.differences[i];
    both += now.are_there[i] * before.are_there[i];
  }
  lag.products += products;
  lag.scales += both * scales;
  lag.steps += scales;
  lag.squares += scales * scales;
}

/// The mean correlation at all lags beyond `lags`: what all pairs of steps have less those within.
double DifferencesInTime::lasting(std::size_t lags) const {
  double products = 0;
  double scales = 0;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    products += sums_[i] * sums_[i];
    scales += scales_[i] * scales_[i];
  }
  for (std::size_t k = 0; k <= lags; ++k) {
    products -= (k == 0 ? 1 : 2) * lags_[k].products;
    scales -= (k == 0 ? 1 : 2) * lags_[k].scales;
  }
  return scales > 0 ? std::clamp(products / scales, 0.0, 1.0) : 0;
}

double DifferencesInTime::independent_pairs() const {
  return std::max(1.0, static_cast<double>(pairs_.size()) / pairs_that_are_one);
}

/// The standard error of a correlation that is 0.
double DifferencesInTime::doubt(const Lag& lag) const {
  return std::sqrt(lag.squares / independent_pairs()) / lag.steps;
}

/// The standard error of a lasting correlation that is 0: that of the mean product of two different
/// steps of so many that are independent.
double DifferencesInTime::doubt_of_lasting(const ErrorCorrelation& correlation) const {
  double together = 1;
  for (const double at_lag : correlation.at_lags)
    together += 2 * std::max(0.0, at_lag - correlation.lasting);
  const double steps = lags_[0].steps * lags_[0].steps / lags_[0].squares / together;
  return std::sqrt(2 / independent_pairs()) / steps;
}

/// The correlations at lags from 1 on, up to the last that can be told from what lasts.
std::vector<double> DifferencesInTime::told(std::size_t lags, double lasting) const {
  std::vector<double> correlations;
  std::size_t last = 0;
  for (std::size_t k = 1; k <= lags && lags_[k].scales > 0; ++k) {
    const double found = std::clamp(lags_[k].products / lags_[k].scales, -1.0, 1.0);
    const bool is_told = std::abs(found - lasting) >= 2 * doubt(lags_[k]);
    correlations.push_back(is_told ? found : lasting);
    if (is_told) last = k;
  }
  correlations.resize(last);
  return correlations;
}

ErrorCorrelation DifferencesInTime::result() const {
  const std::size_t lags = std::min(most_lags, count_ / 4);
  ErrorCorrelation correlation;
  correlation.lasting = lasting(lags);
  correlation.at_lags = told(lags, correlation.lasting);
  if (correlation.lasting > 0 && correlation.lasting < 2 * doubt_of_lasting(correlation))
    return {told(lags, 0), 0};
  return correlation;
}

}  // namespace thiessen
