#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace thiessen {

/// Up to three bands of gauges by elevation, with a third of the gauges in each or nearly so. The
/// bounds between them are the terciles of the gauges' elevations, rounded to a number that a
/// person would choose: a multiple of 1, 2 or 5 times a power of ten that is no more than a quarter
/// of what lies between the terciles. A bound that would leave fewer than `least_gauges` in a band
/// is left out; so few gauges, and gauges at one height, make a single band. Elevations are in any
/// unit.
class ElevationBands {
 public:
  static constexpr std::size_t least_gauges = 3;

  /// `elevations` has one entry for each gauge, NaN where it is not known; those gauges are in no
  /// band. Where none is known, or the list is empty, there are no bands.
  explicit ElevationBands(std::span<const double> elevations);

  /// How many bands there are, the lowest first: 0 to 3.
  std::size_t size() const { return names_.size(); }
  /// The band of a gauge; a gauge at the height of a bound is in the upper one.
  std::optional<std::size_t> of(std::size_t gauge) const {
    return gauge < band_of_.size() ? band_of_[gauge] : std::nullopt;
  }
  /// What a band is called: "below 1,800", "1,800 to 2,400", "above 2,400", or "all" where there is
  /// one.
  const std::string& name(std::size_t band) const { return names_[band]; }
  /// The least elevation of each band but the lowest.
  const std::vector<double>& bounds() const { return bounds_; }

 private:
  std::vector<double> bounds_;
  std::vector<std::string> names_;
  std::vector<std::optional<std::size_t>> band_of_;
};

}  // namespace thiessen
