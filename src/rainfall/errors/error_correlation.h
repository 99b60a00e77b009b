#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "earth/yardstick.h"
#include "rainfall/network/network.h"

namespace thiessen {

/// How the errors of steps go together: the correlation of those of two steps by their lag. Errors
/// of a hill that is always wetter, where no normals say so, last: the correlation does not go to
/// 0.
struct ErrorCorrelation {
  std::vector<double>
      at_lags;         ///< of 1, 2 and so on; none beyond is known to differ from `lasting`
  double lasting = 0;  ///< at all longer lags, from 0 to 1

  /// The correlation of steps so many apart.
  double at(std::size_t lag) const {
    if (lag == 0) return 1;
    return lag <= at_lags.size() ? at_lags[lag - 1] : lasting;
  }
};

/// Warns where errors last without normals, which would tell place by place what does. `file` is
/// that of the readings.
void warn_of_lasting_errors(const ErrorCorrelation& correlation, const std::string& file,
                            Warnings& warnings);

/// Tells the correlation of errors in time from the differences of near gauges, in one pass over a
/// series, for they are errors of one gauge as an estimate of the other.
///
/// The correlation is not centred: what lasts is an error, too. With d for the difference of a pair
/// at a step and s for the root of the mean square of all pairs there, it is the sum of d d' over
/// that of s s', over all pairs and steps at a lag. So a rainy step counts as much as it does in
/// the error of a total, and a variance that changes from step to step is no correlation.
///
/// Lags go up to 32 steps, and to a quarter of the series. One that cannot be told from what lasts
/// (by two of its standard errors) has that, for the noise of many would add up; but lags beyond it
/// may be told again, as those of half a year are where hills are wet in one season. What lasts is
/// the mean over all longer lags, or 0 where it cannot be told from it. Cost of a step: 32 products
/// for each of 256 pairs at most. Memory: those 32 steps.
class DifferencesInTime {
 public:
  static constexpr std::size_t most_lags = 32;

  /// Pairs are each gauge with its two nearest, or 256 of them, spread over the network.
  DifferencesInTime(const Network& network, Metric metric);

  /// Takes the next step's values of the field by place, NaN where all gauges are silent.
  void add(std::span<const double> of_places);
  ErrorCorrelation result() const;

 private:
  struct Pair {
    std::uint32_t a;
    std::uint32_t b;
  };
  /// One step's differences; 0 where there is none, and what tells which there are.
  struct Step {
    std::vector<double> differences;
    std::vector<double> are_there;
    double scale = 0;  // the root of the mean square
  };
  /// Sums over the pairs and steps at one lag.
  struct Lag {
    double products = 0;  // of differences
    double scales = 0;    // of the products of scales
    double squares = 0;   // of these products, one for each pair of steps
    double steps = 0;     // the sum of these products, likewise
  };

  void add_lag(const Step& now, const Step& before, Lag& lag) const;
  std::vector<double> told(std::size_t lags, double lasting) const;
  double lasting(std::size_t lags) const;
  double doubt(const Lag& lag) const;
  double doubt_of_lasting(const ErrorCorrelation& correlation) const;
  double independent_pairs() const;

  std::vector<Pair> pairs_;
  std::vector<Step> steps_;     // the last ones, in turn
  std::size_t count_ = 0;       // of all steps so far
  std::vector<Lag> lags_;       // from 0
  std::vector<double> sums_;    // by pair: of differences
  std::vector<double> scales_;  // by pair: of scales, at the steps that it has
};

}  // namespace thiessen
