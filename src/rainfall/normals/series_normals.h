#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace thiessen {

/// Finds the normals of gauges from one series in which each may lack steps, in one pass.
///
/// A gauge's mean reading misleads where it reports in wet years alone. So a reading is taken as
/// normal x state of its step: N_i = (sum of r_it) / (sum of s_t) over the steps at which gauge i
/// reports, and s_t = (sum of r_it) / (sum of N_i) over the gauges that report at step t; each in
/// turn until no normal changes by more than 1e-10 of itself. This is the maximum of the likelihood
/// of Poisson counts with these means (the method of marginal totals: R. A. Bailey, L. J. Simon,
/// Two studies in automobile insurance ratemaking, ASTIN Bulletin 1, 1960). Normals have the unit
/// of the readings; only their ratios count.
///
/// Of the steps with one set of reporting gauges only the sum is kept, for no more is asked of
/// them. Memory: a bit a gauge for each different set. Cost of a step: its gauges and the search
/// for its set; of the result: 5 to 100 turns of a look at each bit.
class SeriesNormals {
 public:
  explicit SeriesNormals(std::size_t gauges);

  /// Takes the next step's readings, one for each gauge, NaN where it is silent.
  void add(std::span<const double> readings);

  /// How many readings a gauge has.
  std::size_t readings_of(std::size_t gauge) const { return counts_[gauge]; }
  /// The normals by gauge; NaN where a gauge has no reading, 0 where it has never had rain. The
  /// result depends on the order of gauges and steps by rounding alone.
  std::vector<double> result() const;

 private:
  using Set = std::vector<std::uint64_t>;  // a bit for each gauge that reports

  std::vector<double> sums_;
  std::vector<std::size_t> counts_;
  std::map<Set, double> totals_;  // by set: the sum of all its readings
};

}  // namespace thiessen
