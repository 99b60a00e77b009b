#include "rainfall/normals/elevation_units.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace thiessen {

InFeet judge_feet(std::span<const double> of_stations, std::span<const double> of_raster) {
  constexpr double well_above_sea = 30;
  constexpr std::size_t fewest = 3;
  std::vector<double> logarithms;
  for (std::size_t s = 0; s < of_stations.size(); ++s) {
    if (of_stations[s] > well_above_sea && of_raster[s] > well_above_sea)
      logarithms.push_back(std::log(of_stations[s] / of_raster[s]));
  }
  if (logarithms.size() < fewest) return InFeet::nobody;
  const auto middle = logarithms.begin() + static_cast<std::ptrdiff_t>(logarithms.size() / 2);
  std::nth_element(logarithms.begin(), middle, logarithms.end());
  const double foot = -std::log(metres_in_foot);
  const double within = std::log(1.1);
  if (std::abs(*middle - foot) < within) return InFeet::stations;
  if (std::abs(*middle + foot) < within) return InFeet::raster;
  return InFeet::nobody;
}

}  // namespace thiessen
