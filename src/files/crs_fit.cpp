#include "files/crs_fit.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"
#include "study/coordinate_checks.h"

namespace thiessen {
namespace {

constexpr double farthest_longitude = 540;

/// Words the reason why the coordinates are taken to be in this CRS.
Wording claim(const Crs& crs, CrsOrigin origin, const Wording& its_setting) {
  if (origin == CrsOrigin::option) return its_setting + " says " + crs.name();
  if (origin == CrsOrigin::columns) return "the names of its columns say " + crs.name();
  return "its CRS is " + crs.name();
}

template <typename File>
void require_fit(const File& file, const Wording& its_setting) {
  const Reach reach = reach_of(file);
  const Crs& crs = *file.crs;
  const Wording but = ", but " + claim(crs, file.crs_origin, its_setting);
  const double widest = std::max(std::abs(reach.west), std::abs(reach.east));
  const double highest = std::max(std::abs(reach.south), std::abs(reach.north));
  const double nearest = std::min(widest, highest);
  if (crs.geographic()) {
    const bool none = reach.not_degrees == reach.points;
    if (!none || nearest * crs.degrees_per_unit() <= farthest_longitude) return;
    throw Error(Message{file.file, 0, "coordinates are not degrees" + but + ": " + reach.sentence(),
                        "name the CRS that they are in with " + its_setting});
  }
  if (widest <= 180 && highest <= 90 && crs.metres_per_unit() <= 1) {
    throw Error(
        Message{file.file, 0,
                "coordinates look like degrees" + but + ", which is projected: " + reach.sentence(),
                "longitude and latitude are EPSG:4326"});
  }
}

}  // namespace

void require_fit(const StationsFile& stations) {
  require_fit(stations, setting("crs"));
}

void require_fit(const BasinsFile& basins) {
  require_fit(basins, setting("basins_crs"));
}

}  // namespace thiessen
