#pragma once

#include <cstddef>
#include <limits>
#include <string>

#include "base/error.h"
#include "geometry/point.h"
#include "outlines/mapping.h"
#include "study/source_lists.h"

namespace thiessen {

/// The range that the coordinates of a file span, and how many of them can be degrees.
struct Reach {
  double west = 0;
  double south = 0;
  double east = 0;
  double north = 0;
  std::size_t points = 0;
  std::size_t not_degrees = 0;  ///< points that cannot be longitude and latitude

  void see(Point point);
  /// Whether at least half of the points may be longitude and latitude.
  bool looks_like_degrees() const { return 2 * not_degrees <= points; }
  /// Words the range for a message: `x from 3.5 to 9 and y from 40 to 41`.
  std::string sentence() const;
};

Reach reach_of(const StationList& stations);
Reach reach_of(const BasinList& basins);

/// Requires stations of a geographic kind of coordinates to have latitudes in [-90, 90] and
/// longitudes in [-540, 540] degrees. Throws Error with every station that has not, with a hint
/// where longitude and latitude look swapped, and else with the hint `otherwise`.
void require_degrees(const StationList& stations, const CoordinateKind& kind,
                     const Wording& otherwise = {});
/// Requires the vertices of basins to be degrees as the stations have to be. Throws Error with the
/// first bad vertex of each basin.
void require_degrees(const BasinList& basins, const CoordinateKind& kind,
                     const Wording& otherwise = {});

/// Brings longitudes beyond 180 degrees into [-180, 180] by whole turns, with one warning for all.
/// Applies to a geographic kind of coordinates.
void turn_longitudes(StationList& stations, const CoordinateKind& kind, Warnings& warnings);

/// Checks the longitudes of a plane of degrees. Distances in a plane do not go round the Earth, so
/// longitudes that run from -180 to 180 must not stand beside others from 0 to 360.
class LongitudeRange {
 public:
  /// Takes a longitude into account. `whose` names its owner in messages: `station 'X'` or the
  /// like.
  void see(double longitude, const std::string& whose, const std::string& file, std::size_t line);
  /// Throws Error where longitudes of both kinds were seen, naming the two that are farthest apart.
  void require_one_turn() const;

 private:
  struct Extreme {
    double longitude = std::numeric_limits<double>::quiet_NaN();
    std::string whose;
    std::string file;
    std::size_t line = 0;
  };
  Extreme west_;
  Extreme east_;
};

}  // namespace thiessen
