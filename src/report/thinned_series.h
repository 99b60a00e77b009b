#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace thiessen {

/// Some steps of a series that follow each other, as a screen shows them.
struct SeriesStretch {
  /// What a basin's values in these steps come to. All are NaN, and `sum` 0, where it has none.
  struct OfBasin {
    double least = std::numeric_limits<double>::quiet_NaN();
    double largest = std::numeric_limits<double>::quiet_NaN();
    double sum = 0;
    std::size_t values = 0;  ///< how many steps have one
  };

  std::size_t steps = 0;
  std::string begin;  ///< the time of its first step
  std::string time;   ///< of its wettest step by the gauges' sum, of equal ones the first
  std::vector<double> readings;  ///< by station at that step; empty where they are left out
  double gauges_sum = 0;         ///< of these readings
  std::vector<OfBasin> basins;
};

/// How much of a series is kept.
struct SeriesLimits {
  std::size_t values = 120'000;  ///< of stretches times basins
  std::size_t most = 2'000;      ///< stretches, and at least `fewest`, whatever the basins are
  std::size_t fewest = 24;
  std::size_t readings = 1'000'000;  ///< by gauge; where there are more they are left out
};

/// Keeps a series for the screen while its steps pass, in memory that does not grow with them.
///
/// A stretch holds one step as long as there are few; whenever there are twice as many stretches as
/// are wanted, each two that follow each other are joined. So no extreme of a basin is lost, and
/// sums stay those of all steps.
///
/// Cost of a step: its gauges and basins. Memory: twice the limits.
class ThinnedSeries {
 public:
  ThinnedSeries(std::size_t basins, std::size_t gauges, const SeriesLimits& limits = {});

  /// Takes the next step: values by basin and readings by station, NaN where there is none.
  void add(const std::string& time, std::span<const double> basins,
           std::span<const double> readings);

  const std::vector<SeriesStretch>& stretches() const { return stretches_; }
  std::size_t steps() const { return steps_; }
  /// How many steps a stretch holds; the last may hold fewer. 1: nothing is thinned.
  std::size_t steps_in_a_stretch() const { return length_; }
  bool has_readings() const { return has_readings_; }
  /// How many steps each gauge is silent in, and how many at most one after the other, by station.
  const std::vector<std::size_t>& silent_steps() const { return silent_; }
  const std::vector<std::size_t>& longest_silences() const { return longest_; }

 private:
  void note_silence(std::span<const double> readings);
  void join_pairs();
  void leave_readings_out();

  std::size_t wanted_;
  std::size_t most_readings_;
  std::vector<SeriesStretch> stretches_;
  std::size_t length_ = 1;
  std::size_t steps_ = 0;
  bool has_readings_ = true;
  std::vector<std::size_t> silent_;
  std::vector<std::size_t> since_;  ///< by station: how many steps it has been silent by now
  std::vector<std::size_t> longest_;
};

}  // namespace thiessen
