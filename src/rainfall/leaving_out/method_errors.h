#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <vector>

#include "basin/basin.h"
#include "rainfall/leaving_out/elevation_bands.h"
#include "rainfall/leaving_out/error_sums.h"
#include "rainfall/leaving_out/left_out_estimates.h"
#include "rainfall/leaving_out/paired_squares.h"
#include "rainfall/leaving_out/processor_time.h"
#include "rainfall/network/network.h"
#include "rainfall/normals/normal_field.h"

namespace thiessen {

/// A method as it is tried: with normals, or without.
struct TriedMethod {
  PointMethod method;
  bool with_normals;
};

/// The methods that are tried: each without normals and, where there are some, with them next to
/// it.
std::vector<TriedMethod> tried_methods(const NormalField* normals);

/// A step whose gauges are left out one by one.
struct LeftOutStep {
  std::span<const double> readings;  ///< one for each station, NaN where it is silent
  NormalMonth month = {};            ///< where normals are of calendar months
  std::optional<int> year = {};      ///< in whose sum it counts; nothing: in none
  std::size_t stretch = 0;           ///< of time, see PairedSquares
};

/// Leaves each gauge out of each step, tells its reading by the others by several methods, and sums
/// what they are off by.
///
/// Gauges at one place are left out together, and each is told the same. With normals a method is
/// of readings relative to their gauges' normals, times the normal at the place as it is told
/// without the gauge (NormalField::without). A year's sum of a gauge is over the steps at which it
/// was told, both of its readings and of what they are told to be.
///
/// Memory: 160 bytes a station and tried method, independent of the number of steps. Cost of a
/// step: that of LeftOutEstimates for each tried method.
class MethodErrors {
 public:
  /// What a method is off by at the steps, and at the sums of a year.
  struct Errors {
    ErrorSums steps;
    ErrorSums years;
  };

  /// Network, basins and normals, which may be null, must outlive it. There are `stretches` of
  /// time, at least 1. Requires two places.
  MethodErrors(const Network& network, Metric metric, const std::vector<Basin>& basins,
               const NormalField* normals, std::size_t stretches);

  /// Takes the next step; steps of one year follow each other.
  void add(const LeftOutStep& step);
  /// Takes the last year's sums in.
  void finish();

  const std::vector<TriedMethod>& methods() const { return methods_; }
  /// The errors of a tried method at the gauges of a band, or at all.
  Errors errors(std::size_t method) const;
  Errors errors(std::size_t method, const ElevationBands& bands, std::size_t band) const;
  /// How many of the readings were told, and of how many gauges.
  std::size_t readings() const { return readings_; }
  std::size_t gauges() const;
  /// How the squared errors of two tried methods differ at the steps.
  SquaredDifference difference(std::size_t first, std::size_t second) const {
    return squares_.difference(first, second);
  }
  /// Processor time in seconds that a method took for a reading, as the steps that are timed tell
  /// it (see TimedSteps).
  double seconds_of(PointMethod method) const;

 private:
  struct AtStation {
    Errors errors;
    double told_in_year = 0;
  };
  AtStation& at(std::size_t station, std::size_t method) {
    return stations_[station * methods_.size() + method];
  }
  const AtStation& at(std::size_t station, std::size_t method) const {
    return stations_[station * methods_.size() + method];
  }
  template <typename Work>
  void timed(std::size_t times, std::initializer_list<PointMethod> methods, const Work& work);
  void tell_all(const LeftOutStep& step);
  void take(std::size_t station, const LeftOutStep& step);

  const Network& network_;
  const NormalField* normals_;
  std::vector<TriedMethod> methods_;
  LeftOutEstimates estimates_;
  std::vector<std::vector<double>> normals_told_;  // by month: of each station by the others
  std::vector<std::size_t> group_of_;              // by station
  PairedSquares squares_;
  std::vector<AtStation> stations_;
  struct Year {
    double sum = 0;
    bool has_any = false;
  };
  std::vector<Year> read_in_year_;  // by station
  std::optional<int> year_;
  std::size_t readings_ = 0;
  TimedSteps timed_steps_;
  std::array<double, point_methods.size()> seconds_{};
  std::vector<std::vector<double>> told_;  // by tried method: at each place
  std::vector<double> of_reading_;         // squared errors
};

}  // namespace thiessen
