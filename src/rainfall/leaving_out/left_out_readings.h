#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "earth/yardstick.h"
#include "rainfall/leaving_out/elevation_bands.h"
#include "rainfall/leaving_out/error_sums.h"
#include "rainfall/methods/nearest_gauges.h"
#include "rainfall/network/network.h"
#include "rainfall/normals/normal_field.h"

namespace thiessen {

/// Tells by one pass over a series how far off the nearest gauge is, with normals and without: each
/// gauge that reports in a step is left out of it, and its reading is told by the nearest other
/// place with a gauge that reports. With normals that is r N / N_nearest, where N is the gauge's
/// normal as it is told without the gauge itself (NormalField::without). Gauges at one place are
/// left out together, and tell others their mean.
///
/// Nearest is as NearestGauges has it. Cost of a step: some ten nanoseconds a gauge, where not most
/// are silent. Memory: 350 bytes a place, independent of the series.
class LeftOutReadings {
 public:
  /// Errors of the readings, in their unit.
  struct Errors {
    ErrorSums plain;         ///< by the nearest reading itself
    ErrorSums with_normals;  ///< none without normals
  };

  /// Network and normals, which may be null, must outlive it. `bands` has an entry for each
  /// station, or none.
  LeftOutReadings(const Network& network, Metric metric, const NormalField* normals,
                  ElevationBands bands);

  /// Takes the next step's readings, one for each station, NaN where it is silent. `month` is that
  /// of the step where normals are of calendar months.
  void add(std::span<const double> readings, const NormalMonth& month);

  const Errors& all() const { return all_; }
  const ElevationBands& bands() const { return bands_; }
  const Errors& in_band(std::size_t band) const { return by_band_[band]; }

 private:
  std::optional<PlaceIndex> nearest_that_reports(PlaceIndex place,
                                                 std::span<const double> by_place);

  const Network& network_;
  const NormalField* normals_;
  ElevationBands bands_;
  NearestGauges nearest_;
  std::size_t kept_;
  std::vector<PlaceIndex> near_;  // kept_ for each place, the nearest first, without itself
  std::vector<NearestGauges::Near> found_;
  Errors all_;
  std::vector<Errors> by_band_;
};

}  // namespace thiessen
